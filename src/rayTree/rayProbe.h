#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "swScene.h"

// Observes traceRay() without changing it: it gets a scene with a single primitive, which records
// every ray and passes it on to the real scene. Rendering does not use any of this.

namespace rayTree {

/// traceRay(), or another function to observe.
using Trace = std::function<sw::Color(const sw::Ray&, const sw::Scene&, int depth)>;

/// A function that casts more rays than this is stopped: its recursion seems endless.
constexpr std::size_t mostRays = 2000;

/// A ray that the function cast, and its true nearest hit, whatever Answer it got.
struct Query {
    sw::Ray ray;
    bool isHit = false;
    sw::Intersection hit;  ///< undefined without a hit
};

/// The record of one call of the function.
struct Run {
    std::optional<sw::Color> color;  ///< the result; none if it was stopped
    std::vector<Query> queries;      ///< in the order of the calls
};

/// Calls the function with the scene unchanged: color and rays are those of the picture.
Run watch(const Trace& trace, const sw::Ray& ray, const sw::Scene& scene, int depth);

/// The answer that a ray gets.
enum class Answer {
    truth,
    nothing,      ///< a miss, with a black background
    whiteNothing  ///< a miss, with a white background
};

/// Calls the function with a black background and other lights than the scene's.
/// @param answer  gives the answer to each ray by its number, from 0; called in order
Run replay(const Trace& trace, const sw::Ray& ray, const sw::Scene& scene, int depth,
           const std::vector<sw::Light>& lights,
           const std::function<Answer(std::size_t, const sw::Ray&)>& answer);

/// Whether two vectors or rays are the same, bit by bit.
bool isSame(const sw::Vec3& a, const sw::Vec3& b);
bool isSame(const sw::Ray& a, const sw::Ray& b);

}  // namespace rayTree
