#pragma once

#include <vector>

#include "swMaterial.h"

/// The lab's room (scenes/cornell.nff) as lab programs of old spell it out.
namespace bench {

struct RoomTriangle {
    sw::Vec3 v[3];
    sw::Material material;
};

struct RoomSphere {
    sw::Vec3 center;
    sw::Material material;
};

constexpr float roomSphereRadius = 3;
const sw::Vec3 roomLight(0, 30, -5);

std::vector<RoomTriangle> roomTriangles();
std::vector<RoomSphere> roomSpheres();

}  // namespace bench
