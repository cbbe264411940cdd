#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "swRay.h"
#include "swScene.h"

namespace bench {

/// Geometry for our scene and for Embree: either triangles or spheres.
struct Model {
    struct Ball {
        sw::Vec3 center;
        float radius;
    };

    std::string name;
    std::vector<sw::Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< vertex indices
    std::vector<Ball> balls;

    std::size_t size() const { return triangles.size() + balls.size(); }
    sw::Triangle triangle(std::size_t i) const;
};

// All models are about as large as the unit sphere, centred at the origin, and deterministic.

/// A closed surface of 4 n^2 triangles: a sphere with bumps.
Model bumpySphere(std::uint32_t n);

/// Triangles at random places in a cube. Their size keeps its density the same for any number.
Model triangleSoup(std::uint32_t count);

/// The balls of common/sphereflake.h.
Model sphereflake(std::uint32_t count);

/// Our scene of the model, not prepared yet.
sw::Scene sceneOf(const Model& model);

/// The rays of a square picture of the model, row by row in tiles of 16 x 16.
std::vector<sw::Ray> primaryRays(int size);

/// Rays from random points on a sphere around the model to random points in its middle.
std::vector<sw::Ray> randomRays(int count);

}  // namespace bench
