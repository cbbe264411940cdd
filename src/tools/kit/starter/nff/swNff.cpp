#include "swNff.h"

#include <cmath>
#include <optional>

#include "nff/nffShapes.h"
#include "nff/nffTokens.h"
#include "nff/nffView.h"
#include "swFile.h"

namespace sw {
namespace {

struct FileLight {
    Vec3 position;
    std::optional<Color> color;
};

class NffParser {
public:
    NffParser(std::string_view text, const std::string& name, std::vector<NffShape>* list)
        : tokens(text, name), shapes(tokens, scene, list) {}

    NffScene parse() {
        while (!tokens.atEnd()) readStatement();
        if (!view) tokens.failAtNext("expected a view ('v') in the file");
        const float share = 1 / std::sqrt(static_cast<float>(lights.size()));
        for (const FileLight& light : lights)
            scene.push(Light(light.position, light.color.value_or(Color(share, share, share))));
        Camera camera(view->from, view->at, view->up, view->angle);
        camera.setup(view->width, view->height);
        return {scene, camera, view->width, view->height, shapes.warnings()};
    }

private:
    void readStatement() {
        tokens.expectNoNumber();
        const NffToken word = tokens.take();
        if (word.text == "v") return static_cast<void>(view = readView(tokens));
        if (word.text == "b") return scene.setBackground(vector({"b", 3, "r g b"}));
        if (word.text == "l") return readLight();
        if (word.text == "f") return readMaterial();
        for (const ShapeStatement& shape : shapeStatements()) {
            if (word.text != shape.keyword) continue;
            if (!material) tokens.failAtLast("expected a material ('f') before the first object");
            return shape.read(shapes, *material);
        }
        tokens.failAtLast("expected a statement (v, b, l, f, s or p)");
    }

    void readLight() {
        FileLight light{vector({"l", 3, "x y z"}), std::nullopt};
        if (tokens.atNumber()) light.color = vector({"l", 6, "x y z r g b"}, 3);
        lights.push_back(light);
    }

    void readMaterial() {
        float v[8];
        tokens.numbers({"f", 8, "r g b Kd Ks Shine T index"}, v, 8);
        const float kd = v[3], ks = v[4], transparency = v[6], index = v[7];
        if (kd < 0 || ks < 0 || transparency < 0)
            tokens.failAtLast("expected Kd, Ks and T of 0 or more");
        if (transparency > 0 && !(index > 0))
            tokens.failAtLast("expected a positive index of refraction, as T is positive");
        const float diffuse = 1 - ks - transparency;
        const Color color = Color(v[0], v[1], v[2]) * (diffuse > 0 ? kd / diffuse : kd);
        material = Material(color, ks, transparency, transparency > 0 ? index : 1);
    }

    Vec3 vector(const NffTokens::Group& group, int taken = 0) {
        Vec3 v;
        tokens.numbers(group, v.m, 3, taken);
        return v;
    }

    NffTokens tokens;
    Scene scene;
    NffShapes shapes;
    std::optional<NffView> view;
    std::optional<Material> material;
    std::vector<FileLight> lights;
};

}  // namespace

NffScene parseNff(std::string_view text, const std::string& name, std::vector<NffShape>* shapes) {
    constexpr std::string_view mark = "\xef\xbb\xbf";  // some editors begin a file with it
    if (text.substr(0, mark.size()) == mark) text.remove_prefix(mark.size());
    return NffParser(text, name, shapes).parse();
}

NffScene loadNff(const std::filesystem::path& path, std::vector<NffShape>* shapes) {
    std::string text;
    try {
        text = readFile(path);
    } catch (const FileError& error) {
        throw NffError(error.what());
    }
    return parseNff(text, path.string(), shapes);
}

}  // namespace sw
