#pragma once

#include <vector>

#include "swSphere.h"
#include "swTriangle.h"

namespace bench {

/// The contents of the lab's room (scenes/cornell.nff), for other renderers' scenes.
struct Room {
    std::vector<sw::Sphere> spheres;
    std::vector<sw::Triangle> triangles;
    sw::Vec3 light;
};

/// @throws sw::NffError
Room loadRoom();

}  // namespace bench
