#pragma once

#include <cstddef>
#include <functional>
#include <memory>
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

/// A ray that the function cast, and its true nearest hit, whatever answer it got.
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

/// What a ray is told in a replay.
struct Answer {
    const Query* truth = nullptr;  ///< null: it hits nothing ...
    bool isWhite = false;          ///< ... and the background is white, else black
};

/// The light that alone shines in a replay; or one of these.
constexpr int noLight = -1, allLights = -2;

/// A scene to call the function with. For one thread.
class Stage {
public:
    explicit Stage(const sw::Scene& real);
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    /// Calls the function with the scene unchanged: color and rays are those of the picture.
    Run watch(const Trace& trace, const sw::Ray& ray, int depth, std::size_t most = mostRays);

    /// Gives the answer to a ray by its number in the call, from 0; called in order.
    using Answers = std::function<Answer(std::size_t number, const sw::Ray&)>;
    /// Calls the function with a black background and given answers. No color: it was stopped.
    std::optional<sw::Color> replay(const Trace& trace, const sw::Ray& ray, int depth, int light,
                                    const Answers& answers);

    const sw::Scene& real;
    std::size_t asked = 0;  ///< rays that functions have cast here so far

private:
    class Probe;
    sw::Color& background();
    void shine(int light);
    template <typename Answer>
    std::optional<sw::Color> call(const Trace& trace, const sw::Ray& ray, int depth,
                                  std::size_t most, const Answer& truth);

    std::shared_ptr<Probe> probe;
    sw::Scene scene;  // of the probe alone
};

/// Whether two vectors or rays are the same, bit by bit.
bool isSame(const sw::Vec3& a, const sw::Vec3& b);
bool isSame(const sw::Ray& a, const sw::Ray& b);

}  // namespace rayTree
