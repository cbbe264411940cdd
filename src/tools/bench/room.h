#pragma once

#include <vector>

#include "swSphere.h"
#include "swTriangle.h"

namespace bench {

/// What the lab's room (scenes/cornell.nff) consists of, for scenes that are not ours.
struct Room {
    std::vector<sw::Sphere> spheres;
    std::vector<sw::Triangle> triangles;
    sw::Vec3 light;
};

/// @throws sw::NffError
Room loadRoom();

}  // namespace bench
