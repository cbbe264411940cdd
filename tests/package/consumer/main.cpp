#include <swNumerics.h>
#include <swRenderer.h>
#include <swScene.h>

// Renders one pixel with the library alone; its value is known. swNumerics.h includes GLM.
int main() {
    sw::Scene scene;
    scene.push(sw::Sphere(sw::Vec3(0, 0, -5), 1, sw::Material(sw::Color(0.5f, 1, 0.25f))));
    const sw::RenderResult result = sw::render({0, 0, 1, 1}, [&](int, int) {
        sw::Intersection hit;
        const sw::Ray ray(sw::Vec3(0, 0, 0), sw::Vec3(0, 0, -1));
        return scene.intersect(ray, hit) ? hit.material.color * hit.hitT : sw::Color();
    });
    const sw::Color& color = result.image.at(0, 0);
    return color[0] == 2 && color[1] == 4 && sw::num::maxAbs(color) == 4 ? 0 : 1;
}
