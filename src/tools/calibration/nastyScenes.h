#pragma once

#include <string>
#include <vector>

namespace report {

/// A scene that a few samples per pixel get wrong.
struct NastyScene {
    std::string name;
    std::string text;  ///< in Neutral File Format
};

/// Details below a pixel, seen from straight above in a picture of 64 x 64, 3.2 units wide: dashes,
/// dots of several sizes, lights of many times white, dark dots, hairs, a lattice finer than
/// pixels, and some that were made to fool the audit.
std::vector<NastyScene> nastyScenes();

}  // namespace report
