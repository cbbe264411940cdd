#pragma once

#include <vector>

#include "lab/triangleMistakes.h"

/// The known mistakes, step by step of the intersection. Of each list the first is the right one,
/// whose hint is empty.
namespace lab {

/// Where the ray meets the plane.
struct PlaneModel {
    const char* hint;
    float (*t)(const Asked& asked);
    /// The point that goes with it; by default ray.at(t).
    sw::Vec3 (*point)(const Asked& asked, float t) = nullptr;

    sw::Vec3 pointOf(const Asked& asked) const {
        return point ? point(asked, t(asked)) : asked.ray.at(t(asked));
    }
};
const std::vector<PlaneModel>& planeModels();

/// Which t counts.
struct RangeModel {
    const char* hint;
    bool (*holds)(float t, const sw::Ray& ray);
};
const std::vector<RangeModel>& rangeModels();

/// From which sides a triangle is hit.
struct SideModel {
    const char* hint;
    bool fromFront, fromBehind;
};
const std::vector<SideModel>& sideModels();

/// Which points of the plane are inside.
struct InsideModel {
    const char* hint;
    bool (*holds)(float w, float v);
    int power = 0;  ///< w and v come out |n|^power times as large
    /// In the place of the barycentric coordinates of the point, if not null.
    Barycentric (*shares)(const sw::Triangle& t, const sw::Vec3& point) = nullptr;

    bool contains(const sw::Triangle& t, const sw::Vec3& point) const;
};
const std::vector<InsideModel>& insideModels();

/// Rays and triangles that tell the models apart. The places are clear of all sides, and of all
/// lines that a mistake might take for one.
const std::vector<Asked>& probes();

/// The barycentric coordinates of v0 + r.
Barycentric sharesOf(const sw::Triangle& t, const sw::Vec3& r);

inline bool isInside(float w, float v) {
    return w >= 0 && v >= 0 && w + v <= 1;
}

}  // namespace lab
