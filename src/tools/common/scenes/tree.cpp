#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>

#include "tools/common/nffText.h"
#include "tools/common/scenes/scenes.h"

namespace scenes {
namespace {

using glm::dmat3;

dmat3 turnAboutX(double degrees) {
    const double c = glm::cos(glm::radians(degrees)), s = glm::sin(glm::radians(degrees));
    return {{1, 0, 0}, {0, c, s}, {0, -s, c}};
}

dmat3 turnAboutZ(double degrees) {
    const double c = glm::cos(glm::radians(degrees)), s = glm::sin(glm::radians(degrees));
    return {{c, s, 0}, {-s, c, 0}, {0, 0, 1}};
}

// A branch grows from `origin` along the third column of `frame`, as long as that is. Its thickness
// shrinks by the same factor at every fork, its length by the child's own.
void grow(NffText& text, const dmat3& frame, const dvec3& origin, double radius, int forks) {
    constexpr double taper = 0.67;
    const dvec3 end = origin + frame[2];
    text.cone(origin, radius, end, taper * radius);
    text.sphere(end, taper * radius);
    if (forks == 0) return;
    static const dmat3 children[] = {0.65 * turnAboutZ(90) * turnAboutX(40),
                                     0.70 * turnAboutZ(230) * turnAboutX(25)};
    for (const dmat3& child : children) grow(text, frame * child, end, taper * radius, forks - 1);
}

}  // namespace

std::string tree(int size) {
    NffText text({4.5, 0.4, 2}, {0, 0, 1.5}, {0, 0, 1});
    const dvec3 lights[] = {{-5, 5, 50},   {30, -30, 30}, {-40, -30, 20}, {10, 30, 40},
                            {-30, 40, 10}, {50, 25, 20},  {-10, -60, 30}};
    for (const dvec3& light : lights) text.light(light);
    text.material({0.2, 0.7, 0.2}, 1, 0);
    text.square({50, 50, 0}, {-50, 50, 0}, {-50, -50, 0}, {50, -50, 0});
    text.material({0.55, 0.4, 0.2}, 1, 0);
    grow(text, dmat3(1), {0, 0, 0}, 0.15, size);
    return text.take();
}

}  // namespace scenes
