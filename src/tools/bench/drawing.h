#pragma once

#include <string>

#include "tools/bench/picture.h"

namespace bench {

/// Renders a square picture with a function for its pixels.
class Drawing {
public:
    sw::Image image;

    Drawing(Radiance how, int size) : image(size, size), radiance(std::move(how)) {}

    /// Both return the time in seconds: wall time or processor time.
    double draw(int threads);
    double drawAlone();

private:
    void paint(int threads);

    Radiance radiance;
};

/// Pictures differ by rounding, and at some shadow edges by the epsilon.
/// @param most  how far the channels, as a display shows them, may differ on average
/// @throws std::runtime_error if they differ by more
void requireSamePicture(const sw::Image& ours, const sw::Image& other, const std::string& name,
                        double most = 0.01);

}  // namespace bench
