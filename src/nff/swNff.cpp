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

// ", s, c, p or pp".
std::string shapeKeywords() {
    std::string list;
    for (const ShapeStatement& shape : shapeStatements())
        list += (&shape == &shapeStatements().back() ? " or " : ", ") + std::string(shape.keyword);
    return list;
}

class NffParser {
public:
    NffParser(std::string_view text, const std::string& name, std::vector<NffShape>* list)
        : tokens(text, name), shapes(tokens, scene, list) {}

    NffScene parse() {
        while (!tokens.atEnd()) readStatement();
        if (!view)
            tokens.fail(tokens.last().end(), "expected a view ('v') in the file, found none");
        pushLights();
        Camera camera(view->from, view->at, view->up, view->angle);
        camera.setup(view->width, view->height);
        return {scene, camera, view->width, view->height, shapes.warnings()};
    }

private:
    void readStatement() {
        const NffToken word = tokens.take();
        if (word.text == "v") return readOnlyView(word);
        if (word.text == "b") return scene.setBackground(vector("b"));
        if (word.text == "l") return readLight();
        if (word.text == "f") return readMaterial(word);
        for (const ShapeStatement& shape : shapeStatements())
            if (word.text == shape.keyword) return shape.read(shapes, materialFor(word));
        tokens.fail(word.begin(), "expected a statement (v, b, l, f" + shapeKeywords() +
                                      "), found " + describe(word));
    }

    void readOnlyView(const NffToken& word) {
        if (view) tokens.fail(word.begin(), "expected one view, found a second 'v'");
        view = readView(tokens);
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

    void readMaterial(const NffToken& word) {
        float v[8];
        tokens.numbers("f", v, 8, "is the index of refraction missing?");
        const float kd = v[3], ks = v[4], transparency = v[6], index = v[7];
        if (kd < 0 || ks < 0 || transparency < 0)
            tokens.fail(word.begin(), "expected Kd, Ks and T of 0 or more, found a negative one");
        if (transparency > 0 && !(index > 0))
            tokens.failAtLast("expected a positive index of refraction, as T is positive");
        const float diffuse = 1 - ks - transparency;
        const Color color = Color(v[0], v[1], v[2]) * (diffuse > 0 ? kd / diffuse : kd);
        material = Material(color, ks, transparency, transparency > 0 ? index : 1);
    }

    const Material& materialFor(const NffToken& word) const {
        if (!material)
            tokens.fail(word.begin(),
                        "expected a material ('f') before the first object, found none");
        return *material;
    }

    Vec3 vector(const char* keyword) {
        Vec3 v;
        tokens.numbers(keyword, v.m, 3);
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
