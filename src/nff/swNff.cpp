#include "swNff.h"

#include <cmath>
#include <optional>

#include "nff/nffChecks.h"
#include "nff/nffMaterial.h"
#include "nff/nffSkipped.h"
#include "nff/nffText.h"
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
        : tokens(text, name), shapes(tokens, scene, list), checks(shapes) {}

    NffScene parse() {
        while (!tokens.atEnd()) readStatement();
        if (!view)
            tokens.fail(tokens.last().end(), "expected a view ('v') in the file, found none");
        pushLights();
        Camera camera(view->from, view->at, view->up, view->angle);
        camera.setup(view->width, view->height);
        std::vector<std::string> warnings = shapes.warnings();
        for (const std::string& line : checks.warnings()) warnings.push_back(line);
        return {scene, camera, view->width, view->height, warnings};
    }

private:
    void readStatement() {
        tokens.expectNoNumber();
        const NffToken word = tokens.take();
        if (word.text == "v") return readOnlyView(word);
        if (word.text == "b") return readBackground(word);
        if (word.text == "l") return readLight(word);
        if (word.text == "f") return setMaterial(word);
        for (const ShapeStatement& shape : shapeStatements())
            if (word.text == shape.keyword) return shape.read(shapes, materialFor(word));
        if (!skipOldStatement(shapes))
            tokens.failAtLast("expected a statement (v, b, l, f" + shapeKeywords() + ")");
    }

    void readOnlyView(const NffToken& word) {
        if (view) tokens.fail(word.begin(), "expected one view, found a second 'v'");
        view = readView(tokens);
        checks.view(*view);
    }

    void readBackground(const NffToken& word) {
        scene.setBackground(vector({"b", 3, "r g b"}));
        checks.background(word.begin(), scene.background());
    }

    void readLight(const NffToken& word) {
        FileLight light{vector({"l", 3, "x y z"}), std::nullopt};
        if (tokens.atNumber()) light.color = vector({"l", 6, "x y z r g b, or x y z alone"}, 3);
        lights.push_back(light);
        checks.light(word.begin(), light.color.value_or(Color(1, 1, 1)));
    }

    void setMaterial(const NffToken& word) {
        material = readMaterial(shapes);
        checks.material(word.begin(), *material);
    }

    void pushLights() {
        const float share = 1 / std::sqrt(static_cast<float>(lights.size()));
        for (const FileLight& light : lights)
            scene.push(Light(light.position, light.color.value_or(Color(share, share, share))));
    }

    const Material& materialFor(const NffToken& word) {
        if (!material)
            tokens.fail(word.begin(),
                        "expected a material ('f') before the first object, found none");
        checks.shape();
        return *material;
    }

    Vec3 vector(const NffTokens::Group& group, int taken = 0) {
        Vec3 v;
        tokens.numbers(group, v.m, 3, taken);
        return v;
    }

    NffTokens tokens;
    Scene scene;
    NffShapes shapes;
    NffChecks checks;
    std::optional<NffView> view;
    std::optional<Material> material;
    std::vector<FileLight> lights;
};

}  // namespace

NffScene parseNff(std::string_view text, const std::string& name, std::vector<NffShape>* shapes) {
    std::string storage;
    return NffParser(decodeText(text, storage), name, shapes).parse();
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
