#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include "swAdaptive.h"
#include "swNff.h"
#include "swRenderer.h"

namespace report {

/// A scene, ready to be rendered at a given size by all methods.
class Subject {
public:
    /// @param size  of the picture's longer side, in pixels
    Subject(sw::NffScene scene, int size);
    Subject(const Subject&) = delete;
    Subject& operator=(const Subject&) = delete;

    /// n x n samples per pixel.
    sw::RenderResult uniformly(sw::SamplePattern pattern, int n, std::uint64_t seed) const;
    /// The same in multijitter, with sums in double precision and a seed that no study uses.
    sw::RenderResult reference(int n) const;
    sw::AdaptiveResult adaptively(const sw::AdaptiveOptions& options) const;

    int width() const { return all.x1; }
    int height() const { return all.y1; }

private:
    sw::RenderResult draw(const std::function<sw::Color(int x, int y)>& pixel,
                          sw::SamplePattern pattern, int n, std::uint64_t seed) const;

    sw::NffScene file;
    sw::Window all;
    std::function<sw::Color(float x, float y)> radiance;
};

}  // namespace report
