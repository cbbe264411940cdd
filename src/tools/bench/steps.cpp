#include <array>
#include <filesystem>

#include "app/scenePath.h"
#include "swNff.h"
#include "swRenderer.h"
#include "tools/bench/parts.h"
#include "tools/bench/picture.h"
#include "tools/common/mainFunctions.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb_image_write.h>

namespace bench {
namespace {

const char* const stepNames[] = {"load", "build", "trace", "PNG"};

struct Run {
    std::array<double, 4> seconds{};
    std::size_t bytes = 0;     // of the PNG
    std::size_t stbBytes = 0;  // of the same picture as stb writes it
};

std::size_t sizeFromStb(const sw::Image& image) {
    std::vector<std::uint8_t> bytes;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            for (const float channel : image.at(x, y).m) bytes.push_back(sw::toByte(channel));
    std::size_t written = 0;
    const auto count = [](void* sum, void*, int size) {
        *static_cast<std::size_t*>(sum) += static_cast<std::size_t>(size);
    };
    stbi_write_png_to_func(count, &written, image.width(), image.height(), 3, bytes.data(),
                           3 * image.width());
    return written;
}

// Renders a picture of the lab as the program does, with all threads.
Run runOnce(int size, const std::filesystem::path& png) {
    Run run;
    std::optional<sw::NffScene> file;
    sw::Image image(size, size);
    run.seconds[0] =
        secondsOf([&] { file.emplace(sw::loadNff(findShippedScene("cornell.nff", ""))); });
    file->camera.setup(size, size);
    run.seconds[1] = secondsOf([&] { file->scene.prepare(); });
    const auto pixel = [&](int x, int y) {
        return lab::samplePixel(static_cast<float>(x), static_cast<float>(y), labSamples, labDepth,
                                file->camera, file->scene);
    };
    run.seconds[2] = secondsOf([&] { image = sw::render({0, 0, size, size}, pixel).image; });
    run.seconds[3] = secondsOf([&] { sw::writePng(image, png); });
    run.bytes = std::filesystem::file_size(png);
    std::filesystem::remove(png);
    run.stbBytes = sizeFromStb(image);
    return run;
}

double total(const Run& run) {
    double sum = 0;
    for (const double s : run.seconds) sum += s;
    return sum;
}

template <typename Value>
double medianOf(const std::vector<Run>& runs, const Value& value) {
    std::vector<double> values;
    for (const Run& run : runs) values.push_back(value(run));
    return median(values);
}

void addLines(int size, const std::vector<Run>& runs, bool judge, Lines& lines) {
    const std::string name = "lab picture " + std::to_string(size) + "x" + std::to_string(size);
    const double all = medianOf(runs, total) * 1e3;
    for (std::size_t i = 0; i < 4; ++i)
        lines.push_back({name + ": " + stepNames[i], "the whole run", "ms",
                         medianOf(runs, [&](const Run& r) { return r.seconds[i] * 1e3; }), all,
                         medianOf(runs, [&](const Run& r) { return r.seconds[i] / total(r); })});
    const auto target = [&](double most) {
        return judge ? std::optional(Target{Target::atMost, most}) : std::nullopt;
    };
    lines.push_back({name + ": PNG", "trace", "ms",
                     medianOf(runs, [](const Run& r) { return r.seconds[3] * 1e3; }),
                     medianOf(runs, [](const Run& r) { return r.seconds[2] * 1e3; }),
                     medianOf(runs, [](const Run& r) { return r.seconds[3] / r.seconds[2]; }),
                     target(0.15)});
    const double ours = static_cast<double>(runs[0].bytes) / 1024;
    const double stb = static_cast<double>(runs[0].stbBytes) / 1024;
    lines.push_back(
        {name + ": size of the PNG", "stb's default", "KiB", ours, stb, ours / stb, target(1.3)});
}

}  // namespace

void measureSteps(const Setup& setup, Lines& lines) {
    const std::filesystem::path png = setup.output / "bench-temporary.png";
    for (const int size : {512, 1024}) {
        const int side = setup.quick ? size / 8 : size;
        std::vector<Run> runs;
        for (int i = 0; i < setup.repetitions(5); ++i) runs.push_back(runOnce(side, png));
        addLines(side, runs, size == 1024, lines);
    }
}

}  // namespace bench
