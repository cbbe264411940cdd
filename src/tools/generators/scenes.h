#pragma once

#include <string>

#include "tools/common/mount.h"

/// Scenes that grow with a size, in Neutral File Format (swNff.h): the constructions of Eric
/// Haines' Standard Procedural Databases (A Proposal for Standard Graphics Environments, IEEE
/// Computer Graphics and Applications 7(11), 1987). The same size always gives the same text.
namespace scenes {

/// A scene generator.
struct Generator {
    const char* name;
    const char* shows;
    int least, most, usual;             ///< sizes; the largest have a million shapes or two
    std::string (*generate)(int size);  ///< least <= size <= most
};

/// A sphere with nine smaller ones on it, each with nine on it and so on, above a ground of one
/// polygon: (9^(size + 1) - 1) / 8 mirroring spheres.
std::string balls(int size);

/// A tetrahedron of tetrahedra of tetrahedra: 4^size equilateral triangles in the cube -1..1.
std::string tetra(int size);

constexpr Generator generators[] = {
    {"balls", "sphereflake: reflection", 0, 6, 4, balls},
    {"tetra", "pyramid of tetrahedra: many hidden surfaces", 1, 10, 6, tetra},
    {"mount", "fractal mountain under glass spheres: refraction", 1, 10, 6, mount},
};

}  // namespace scenes
