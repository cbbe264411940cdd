#include "swNff.h"

#include <cmath>
#include <optional>
#include <vector>

#include "nffTokens.h"
#include "swFile.h"
#include "swNumerics.h"

namespace sw {
namespace {

// Limits against files that ask for absurd amounts of work.
constexpr float largestSide = 16384;
constexpr float mostVertices = 1000000;

struct View {
    Vec3 from, at, up;
    float angle = 0;
    int width = 0, height = 0;
};

struct FileLight {
    Vec3 position;
    std::optional<Color> color;
};

bool isZero(const Vec3& v) {
    return v.norm() == 0;
}

bool areParallel(const Vec3& u, const Vec3& v) {
    return (Vec3(u).normalize() % Vec3(v).normalize()).norm() < 8 * num::unitRoundoff;
}

bool isWholeNumber(float x, float least, float most) {
    return x >= least && x <= most && x == std::floor(x);
}

class NffParser {
public:
    NffParser(std::string_view text, const std::string& name) : tokens(text, name) {}

    NffScene parse() {
        while (!tokens.atEnd()) readStatement();
        if (!view)
            tokens.fail(tokens.last().end(), "expected a view ('v') in the file, found none");
        pushLights();
        Camera camera(view->from, view->at, view->up, view->angle);
        camera.setup(view->width, view->height);
        return {scene, camera, view->width, view->height};
    }

private:
    void readStatement() {
        const NffToken word = tokens.take();
        statement = word.begin();
        if (word.text == "v") return readView();
        if (word.text == "b") return scene.setBackground(vector("b"));
        if (word.text == "l") return readLight();
        if (word.text == "f") return readMaterial();
        if (word.text == "s") return readSphere();
        if (word.text == "p") return readPolygon();
        fail("expected a statement (v, b, l, f, s or p), found " + describe(word));
    }

    void readView() {
        if (view) fail("expected one view, found a second 'v'");
        View v;
        v.from = vectorAfter("from");
        v.at = vectorAfter("at");
        if (isZero(v.at - v.from)) fail("expected 'from' and 'at' to differ, found the same point");
        v.up = vectorAfter("up");
        if (isZero(v.up) || areParallel(v.up, v.at - v.from))
            fail("expected 'up' to point across the view, found it zero or along the view");
        v.angle = numberAfter("angle");
        if (!(v.angle > 0 && v.angle < 180))
            failAtLast("expected an angle between 0 and 180 degrees");
        numberAfter("hither");  // a near clipping plane, which ray tracing does not need
        readResolution(v);
        view = v;
    }

    void readResolution(View& v) {
        expect("resolution");
        v.width = readSide(0);
        v.height = readSide(1);
    }

    int readSide(int before) {
        float side;
        tokens.numbers({"resolution", 2, ""}, before, &side, 1);
        if (!isWholeNumber(side, 1, largestSide))
            failAtLast("expected a width and a height from 1 to 16384");
        return static_cast<int>(side);
    }

    void readLight() {
        FileLight light{vector("l"), std::nullopt};
        if (tokens.atNumber()) light.color = vector("l x y z");
        lights.push_back(light);
    }

    void pushLights() {
        const float share = 1 / std::sqrt(static_cast<float>(lights.size()));
        for (const FileLight& light : lights)
            scene.push(Light(light.position, light.color.value_or(Color(share, share, share))));
    }

    void readMaterial() {
        float v[8];
        tokens.numbers("f", v, 8, "is the index of refraction missing?");
        const float kd = v[3], ks = v[4], transparency = v[6], index = v[7];
        if (kd < 0 || ks < 0 || transparency < 0)
            fail("expected Kd, Ks and T of 0 or more, found a negative one");
        if (transparency > 0 && !(index > 0))
            failAtLast("expected a positive index of refraction, as T is positive");
        const float diffuse = 1 - ks - transparency;
        const Color color = Color(v[0], v[1], v[2]) * (diffuse > 0 ? kd / diffuse : kd);
        material = Material(color, ks, transparency, transparency > 0 ? index : 1);
    }

    void readSphere() {
        requireMaterial();
        float v[4];
        tokens.numbers("s", v, 4, "is the radius missing?");
        if (!(v[3] > 0)) failAtLast("expected a positive radius");
        scene.push(Sphere(Vec3(v[0], v[1], v[2]), v[3], *material));
    }

    void readPolygon() {
        requireMaterial();
        float count;
        tokens.numbers("p", &count, 1);
        if (!isWholeNumber(count, 3, mostVertices))
            failAtLast("expected a number of vertices from 3 to 1000000");
        const int size = 3 * static_cast<int>(count);
        const NffTokens::Group group{"p", size, "a polygon has three numbers per vertex"};
        // The triangles of a convex polygon, all of which meet in its first vertex.
        Vec3 corner[3];
        for (int i = 0; i < size; i += 3) {
            if (i >= 9) corner[1] = corner[2];
            tokens.numbers(group, i, corner[std::min(i / 3, 2)].m, 3);
            if (i >= 6) scene.push(Triangle(corner, *material));
        }
    }

    void requireMaterial() const {
        if (!material) fail("expected a material ('f') before the first object, found none");
    }

    void expect(const char* keyword) {
        const NffToken& found = tokens.peek();
        if (found.text != keyword)
            tokens.fail(
                tokens.atEnd() ? tokens.last().end() : found.begin(),
                std::string("expected '") + keyword + "' in the view, found " + describe(found));
        tokens.take();
    }

    Vec3 vector(const char* keyword) {
        Vec3 v;
        tokens.numbers(keyword, v.m, 3);
        return v;
    }

    Vec3 vectorAfter(const char* keyword) {
        expect(keyword);
        return vector(keyword);
    }

    float numberAfter(const char* keyword) {
        expect(keyword);
        float value;
        tokens.numbers(keyword, &value, 1);
        return value;
    }

    [[noreturn]] void fail(const std::string& message) const { tokens.fail(statement, message); }

    [[noreturn]] void failAtLast(const std::string& message) const {
        tokens.fail(tokens.last().begin(), message + ", found " + describe(tokens.last()));
    }

    NffTokens tokens;
    const char* statement = nullptr;  // the one being read
    Scene scene;
    std::optional<View> view;
    std::optional<Material> material;
    std::vector<FileLight> lights;
};

}  // namespace

NffScene parseNff(std::string_view text, const std::string& name) {
    return NffParser(text, name).parse();
}

NffScene loadNff(const std::filesystem::path& path) {
    std::string text;
    try {
        text = readFile(path);
    } catch (const FileError& error) {
        throw NffError(error.what());
    }
    return parseNff(text, path.string());
}

}  // namespace sw
