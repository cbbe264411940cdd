#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "swScene.h"

// Watches what traceRay() does without changing it: the scene that it is handed holds one
// primitive, which passes every question on to the real scene. Nothing of this is in the way of
// rendering.

namespace rayTree {

/// traceRay(), or another function to be watched.
using Trace = std::function<sw::Color(const sw::Ray&, const sw::Scene&, int depth)>;

/// A function that asks more often than this is stopped: it does not seem to end by itself.
constexpr std::size_t mostRays = 2000;

/// What was asked of the scene, and the nearest hit in truth, whatever the answer was.
struct Query {
    sw::Ray ray;
    bool isHit = false;
    sw::Intersection hit;  ///< means nothing without a hit
};

/// What happened in one call of the function.
struct Run {
    std::optional<sw::Color> color;  ///< what came back; none where it was stopped
    std::vector<Query> queries;      ///< one after the other
};

/// Calls the function with the scene as it is: color and rays are those of the picture.
Run watch(const Trace& trace, const sw::Ray& ray, const sw::Scene& scene, int depth);

/// What a ray is told that it hits.
enum class Answer {
    truth,
    nothing,      ///< nothing, before a black background
    whiteNothing  ///< nothing, before a white background
};

/// Calls the function before a black background and with some lights instead of the scene's.
/// @param answer  what to answer the ray with that number, counted from 0; called in order
Run replay(const Trace& trace, const sw::Ray& ray, const sw::Scene& scene, int depth,
           const std::vector<sw::Light>& lights,
           const std::function<Answer(std::size_t, const sw::Ray&)>& answer);

/// Whether two vectors or rays are the same, bit by bit.
bool isSame(const sw::Vec3& a, const sw::Vec3& b);
bool isSame(const sw::Ray& a, const sw::Ray& b);

}  // namespace rayTree
