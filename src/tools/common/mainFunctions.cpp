#include "tools/common/mainFunctions.h"

#include <concepts>

// Inline: nobody calls it, so it is checked but makes no code that asks for the whole program.
#define main inline swtracerMain
#include SW_MAIN
#undef main

namespace {

template <typename... Arguments>
constexpr bool isTraceRay = requires(Arguments... a) {
    { ::traceRay(a...) } -> std::convertible_to<sw::Color>;
};
static_assert(isTraceRay<const sw::Ray&, const sw::Scene&, int>,
              "traceRay() in main.cpp must take a ray, a scene and a depth, and return a color: "
              "Color traceRay(const Ray& ray, const Scene& scene, int depth)");

template <typename... Arguments>
constexpr bool isSamplePixel = requires(Arguments... a) {
    { ::samplePixel(a...) } -> std::convertible_to<sw::Color>;
};
static_assert(isSamplePixel<float, float, int, int, const sw::Camera&, const sw::Scene&>,
              "samplePixel() in main.cpp must return a color and take: float x, float y, int n, "
              "int depth, const Camera& camera, const Scene& scene");

// Says which function runs, as long as it does.
class Running {
public:
    explicit Running(const char* name) : outer(lab::studentFunction) {
        lab::studentFunction = name;
    }
    ~Running() { lab::studentFunction = outer; }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

private:
    const char* outer;
};

}  // namespace

sw::Color lab::traceRay(const sw::Ray& ray, const sw::Scene& scene, int depth) {
    const Running running("traceRay()");
    return ::traceRay(ray, scene, depth);
}

sw::Color lab::samplePixel(float x, float y, int n, int depth, const sw::Camera& camera,
                           const sw::Scene& scene) {
    const Running running("samplePixel()");
    return ::samplePixel(x, y, n, depth, camera, scene);
}
