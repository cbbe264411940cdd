#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "app/explore/packed.h"
#include "app/explore/pageText.h"
#include "app/explore/recording.h"
#include "app/explore/shapeColumns.h"

namespace {

using namespace sw;
using Json = nlohmann::ordered_json;

Json jsonOf(const Vec3& v) {
    return {v[0], v[1], v[2]};  // NaN and infinity become null
}

// The ray through a point of the picture is forward + (x - w / 2) * right + (y - h / 2) * down.
Json cameraOf(const Camera& camera, float width, float height) {
    const Ray middle = camera.getRay(width / 2, height / 2);
    const auto step = [&](float x, float y, float pixels) {
        const Vec3 dir = camera.getRay(x, y).dir;
        return (dir * (1 / (dir * middle.dir)) - middle.dir) * (1 / pixels);
    };
    return {{"eye", jsonOf(middle.orig)},
            {"forward", jsonOf(middle.dir)},
            {"right", jsonOf(step(width, height / 2, width / 2))},
            {"down", jsonOf(step(width / 2, height, height / 2))}};
}

// What the file says of the light and the rays of its pixels; script tags cannot end in it.
std::string headOf(const Options& options, const NffScene& file, const Recording& recording,
                   const std::vector<std::string>& faultTexts, const Json& materials) {
    const Window& crop = *options.crop;
    Json lights = Json::array();
    for (const Light& light : file.scene.lights())
        lights.push_back({{"position", jsonOf(light.position)}, {"color", jsonOf(light.color)}});
    const Json json{{"scene", options.scene.filename().string()},
                    {"width", options.width},
                    {"height", options.height},
                    {"left", crop.x0},
                    {"top", crop.y0},
                    {"step", recording.step},
                    {"columns", recording.columns},
                    {"rows", recording.rows},
                    {"rays", recording.rays.rays},
                    {"endless", recording.rays.endless},
                    {"gamma", options.gamma},
                    {"depth", options.depth},
                    {"background", jsonOf(file.scene.background())},
                    {"camera", cameraOf(file.camera, static_cast<float>(options.width),
                                        static_cast<float>(options.height))},
                    {"lights", lights},
                    {"materials", materials},
                    {"faults", faultTexts}};
    std::string text = json.dump(-1, ' ', true, Json::error_handler_t::replace);
    for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;)
        text.replace(at, 1, "\\u003c");
    return text;
}

class Page {
public:
    void addColumn(const std::string& name, int bytes, const std::vector<std::uint32_t>& values) {
        data += "<script type=\"text/plain\" class=\"column\" data-name=\"" + name +
                "\" data-bytes=\"" + std::to_string(bytes) + "\" data-count=\"" +
                std::to_string(values.size()) + "\">" +
                base64(deflated(transposed(values, bytes))) + "</script>\n";
    }
    void addHead(const std::string& json) {
        data += "<script type=\"application/json\" id=\"head\">" + json + "</script>\n";
    }
    std::string text() const {
        std::string page(pageTemplate());
        const std::string_view place = "<!-- data -->";
        return page.replace(page.find(place), place.size(), data);
    }

private:
    std::string data;
};

// Colour of an error between black 0.0001 and white 1, as a number from 0 to 255.
std::uint32_t errorCode(const Color& error) {
    const float mean = (error[0] + error[1] + error[2]) / 3;
    if (std::isnan(mean)) return 0;
    return static_cast<std::uint32_t>(
        std::clamp(1 + 254 * (std::log10(std::max(mean, 1e-9f)) + 4) / 4, 1.f, 255.f));
}

void addErrors(Page& page, const Recording& recording, const Image& errors) {
    std::vector<std::uint32_t> codes;
    for (int y = 0; y < errors.height(); y += recording.step)
        for (int x = 0; x < errors.width(); x += recording.step)
            codes.push_back(errorCode(errors.at(x, y)));
    if (std::all_of(codes.begin(), codes.end(), [](std::uint32_t code) { return code == 0; }))
        codes.clear();  // no estimate
    page.addColumn("error", 1, codes);
}

}  // namespace

std::string explorePage(const Options& options, const NffScene& file, const Recording& recording,
                        const Image& errors) {
    Page page;
    for (const Column& column : recording.rays.columns)
        page.addColumn(column.name, column.bytes, column.values);

    std::vector<std::uint32_t> rays, starts[3], faultRays, faultKinds;
    for (const RayColumns::Origin& origin : recording.rays.origins) {
        rays.push_back(origin.ray);
        for (std::size_t i = 0; i < 3; ++i)
            starts[i].push_back(std::bit_cast<std::uint32_t>(origin.start.m[i]));
    }
    std::map<std::string, std::uint32_t> kinds;
    std::vector<std::string> texts;
    for (const RayColumns::Fault& fault : recording.rays.faults) {
        const auto [kind, isNew] =
            kinds.emplace(fault.text, static_cast<std::uint32_t>(texts.size()));
        if (isNew) texts.push_back(fault.text);
        faultRays.push_back(fault.ray);
        faultKinds.push_back(kind->second);
    }
    page.addColumn("originRay", 4, rays);
    page.addColumn("originX", 4, starts[0]);
    page.addColumn("originY", 4, starts[1]);
    page.addColumn("originZ", 4, starts[2]);
    page.addColumn("faultRay", 4, faultRays);
    page.addColumn("faultKind", 2, faultKinds);
    addErrors(page, recording, errors);

    const ShapeColumns shapes(recording.shapes);
    for (const Column& column : shapes.columns)
        page.addColumn(column.name, column.bytes, column.values);
    Json materials = Json::array();
    for (const Material& m : shapes.materials)
        materials.push_back({{"color", jsonOf(m.color)},
                             {"reflectivity", m.reflectivity},
                             {"transparency", m.transparency},
                             {"index", m.refractiveIndex}});
    page.addHead(headOf(options, file, recording, texts, materials));
    return page.text();
}
