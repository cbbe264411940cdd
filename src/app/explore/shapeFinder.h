#pragma once

#include <cstdint>
#include <vector>

#include "swNff.h"

/// Finds the shape of a scene file that a ray hit, among any number. For many threads.
class ShapeFinder {
public:
    /// @param shapes  must outlive the finder
    explicit ShapeFinder(const std::vector<sw::NffShape>& shapes);

    /// The shape's number in the list; notFound: it is none of them.
    /// @param hit    the scene's hit of the ray
    /// @param guess  looked at first
    std::size_t find(const sw::Ray& ray, const sw::Intersection& hit, std::size_t guess) const;
    static constexpr std::size_t notFound = static_cast<std::size_t>(-1);

private:
    bool isHit(std::size_t number, const sw::Ray& ray, const sw::Intersection& hit) const;

    const std::vector<sw::NffShape>& shapes;
    sw::Scene numbered;
};
