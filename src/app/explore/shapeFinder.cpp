#include "app/explore/shapeFinder.h"

#include "rayTree/rayProbe.h"

namespace {

using namespace sw;

// A shape whose hits tell its number, as a refractive index: exact up to 2^24.
class Numbered : public Primitive {
public:
    Numbered(std::shared_ptr<const Primitive> real, std::size_t itsNumber)
        : shape(std::move(real)), number(static_cast<float>(itsNumber)) {}

    bool intersect(const Ray& ray, Intersection& hit) const override {
        if (!shape->intersect(ray, hit)) return false;
        hit.material.refractiveIndex = number;
        return true;
    }
    Bounds bounds() const override { return shape->bounds(); }

private:
    std::shared_ptr<const Primitive> shape;
    float number;
};

}  // namespace

ShapeFinder::ShapeFinder(const std::vector<NffShape>& all) : shapes(all) {
    for (std::size_t i = 0; i < shapes.size(); ++i)
        numbered.push(std::make_shared<Numbered>(shapes[i].primitive, i));
    numbered.prepare();
}

bool ShapeFinder::isHit(std::size_t number, const Ray& ray, const Intersection& hit) const {
    Intersection candidate;
    return number < shapes.size() && shapes[number].primitive->intersect(ray, candidate) &&
           rayTree::isSame(candidate.position, hit.position) &&
           rayTree::isSame(candidate.normal, hit.normal) &&
           rayTree::isSame(candidate.material.color, hit.material.color);
}

std::size_t ShapeFinder::find(const Ray& ray, const Intersection& hit, std::size_t guess) const {
    if (isHit(guess, ray, hit)) return guess;
    Intersection candidate;
    if (!numbered.intersect(ray, candidate)) return notFound;
    const auto nearest = static_cast<std::size_t>(candidate.material.refractiveIndex);
    if (isHit(nearest, ray, hit)) return nearest;
    // Two shapes at one place: the scene took the other one.
    constexpr std::size_t fewShapes = 1000;
    for (std::size_t i = 0; i < shapes.size() && shapes.size() <= fewShapes; ++i)
        if (isHit(i, ray, hit)) return i;
    return notFound;
}
