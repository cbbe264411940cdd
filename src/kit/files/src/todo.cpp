#include "todo.h"

#include "reference.h"

// What the library's part of the tasks does until it is written.

namespace sw::todo {

using reference::answersFor;

bool intersect(const Triangle& triangle, const Ray& ray, Intersection& hit) {
    if constexpr (answersFor(2)) return reference::intersect(triangle, ray, hit);
    return false;
}

Ray reflectedRay(const Intersection& hit) {
    if constexpr (answersFor(4)) return reference::reflectedRay(hit);
    return Ray(hit.position, hit.normal, 0, 0);
}

Ray refractedRay(const Intersection& hit) {
    if constexpr (answersFor(5)) return reference::refractedRay(hit);
    return Ray(hit.position, hit.normal, 0, 0);
}

}  // namespace sw::todo
