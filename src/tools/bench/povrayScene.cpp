#include "tools/bench/povrayScene.h"

#include <cmath>
#include <limits>
#include <ostream>
#include <stdexcept>

#include "nff/plainText.h"

namespace bench {
namespace {

using sw::Vec3;

std::ostream& operator<<(std::ostream& out, const Vec3& v) {
    return out << '<' << v[0] << ',' << v[1] << ',' << v[2] << '>';
}

// Numbers with all digits of a float, in any locale.
std::ostringstream stream() {
    std::ostringstream out = sw::plainStream();
    out.precision(std::numeric_limits<float>::max_digits10);
    return out;
}

// What lets light through weakens POV-Ray's diffuse light by itself.
std::string surface(const sw::Material& m) {
    const float r = m.reflectivity, t = m.transparency;
    const float diffuse = t < 1 ? std::fmax(1 - r - t, 0.0f) / (1 - t) : 0;
    std::ostringstream out = stream();
    out << "texture { pigment { rgb " << m.color << " transmit " << t
        << " } finish { ambient 0 specular 0 phong 0 diffuse " << diffuse << " reflection " << r
        << " } }";
    if (t > 0) out << " interior { ior " << m.refractiveIndex << " }";
    return out.str();
}

class Writer {
public:
    explicit Writer(std::ostream& output) : out(output) {}

    void add(const sw::Primitive& primitive) {
        if (const auto* triangle = dynamic_cast<const sw::Triangle*>(&primitive)) {
            addTriangle("triangle", triangle->vertices, nullptr, triangle->material);
        } else if (const auto* patch = dynamic_cast<const sw::Patch*>(&primitive)) {
            addTriangle("smooth_triangle", patch->triangle.vertices, patch->normals,
                        patch->material);
        } else if (const auto* sphere = dynamic_cast<const sw::Sphere*>(&primitive)) {
            std::ostringstream text = stream();
            text << "sphere { " << sphere->center << ',' << sphere->radius;
            addObject(text.str(), sphere->material);
        } else if (const auto* cone = dynamic_cast<const sw::Cone*>(&primitive)) {
            addCone(*cone);
        } else {
            throw std::runtime_error("a shape that POV-Ray does not know");
        }
    }

private:
    void addCone(const sw::Cone& c) {
        std::ostringstream text = stream();
        if (c.baseRadius == c.apexRadius)
            text << "cylinder { " << c.base << ',' << c.apex << ',' << c.baseRadius << " open";
        else
            text << "cone { " << c.base << ',' << c.baseRadius << ',' << c.apex << ','
                 << c.apexRadius << " open";
        addObject(text.str(), c.material);
    }

    void addTriangle(const char* kind, const Vec3* vertices, const Vec3* normals,
                     const sw::Material& material) {
        std::ostringstream text = stream();
        text << kind << " { ";
        for (int i = 0; i < 3; ++i) {
            text << (i > 0 ? "," : "") << vertices[i];
            if (normals) text << ',' << normals[i];
        }
        addObject(text.str(), material);
    }

    // POV-Ray's shadow rays go through glass, weakened: another object takes the shadows over.
    void addObject(const std::string& shape, const sw::Material& material) {
        const bool isGlass = material.transparency > 0;
        out << shape << ' ' << surface(material) << (isGlass ? " no_shadow }\n" : " }\n");
        if (isGlass) out << shape << ' ' << surface({}) << " no_image no_reflection }\n";
    }

    std::ostream& out;
};

// Directions to the middle of the picture and, across it, to its right and upper edges.
void writeCamera(std::ostream& out, sw::Camera camera) {
    camera.setup(2, 2);
    const sw::Ray middle = camera.getRay(1, 1);
    const auto across = [&](float x, float y) {
        const Vec3 edge = camera.getRay(x, y).dir;
        return 2 * (edge / (edge * middle.dir) - middle.dir);
    };
    out << "camera { location " << middle.orig << " direction " << middle.dir << " right "
        << across(2, 1) << " up " << across(1, 0) << " }\n";
}

}  // namespace

std::string povrayScene(const sw::NffScene& scene, const std::vector<sw::NffShape>& shapes,
                        int depth) {
    std::ostringstream out = stream();
    out << "#version 3.7;\nglobal_settings { assumed_gamma 1 adc_bailout 0 max_trace_level "
        << depth + 1 << " }\nbackground { rgb " << scene.scene.background() << " }\n";
    writeCamera(out, scene.camera);
    for (const sw::Light& light : scene.scene.lights())
        out << "light_source { " << light.position << " rgb " << light.color << " }\n";
    Writer writer(out);
    for (const sw::NffShape& shape : shapes) writer.add(*shape.primitive);
    return out.str();
}

}  // namespace bench
