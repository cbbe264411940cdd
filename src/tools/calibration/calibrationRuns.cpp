#include "tools/calibration/calibrationRuns.h"

#include <cmath>
#include <fstream>
#include <functional>

#include "swFile.h"
#include "swMetrics.h"

namespace report {
namespace {

namespace fs = std::filesystem;

// FNV-1a (Fowler, Noll and Vo).
std::uint64_t hashOf(const std::string& text) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return hash;
}

// The picture's floats, row by row, then the error.
std::vector<float> read(const fs::path& file, std::size_t count) {
    std::vector<float> numbers(count);
    std::ifstream in(file, std::ios::binary);
    in.read(reinterpret_cast<char*>(numbers.data()),
            static_cast<std::streamsize>(count * sizeof(float)));
    if (!in || in.peek() != std::ifstream::traits_type::eof()) numbers.clear();
    return numbers;
}

std::vector<float> render(const Subject& subject, int n) {
    const sw::RenderResult result = subject.reference(n);
    std::vector<float> numbers;
    for (int y = 0; y < subject.height(); ++y)
        for (int x = 0; x < subject.width(); ++x)
            for (const float channel : result.image.at(x, y).m) numbers.push_back(channel);
    numbers.push_back(static_cast<float>(result.estimatedRmse));
    return numbers;
}

}  // namespace

bool CalibrationRow::isNear(const Statement& run) const {
    const double ratio = run.printed / run.trueRmse;
    return (ratio > 1 / 1.5 && ratio < 1.5) ||
           std::fabs(run.printed - run.trueRmse) <= referenceError;
}

bool CalibrationRow::isInBand(const Statement& run) const {
    return std::fabs(run.printed - run.trueRmse) <= 3 * run.standardError + referenceError;
}

bool CalibrationRow::meansTarget(const Statement& run) const {
    return mode.kind != Mode::Kind::targetRmse || run.trueRmse <= 1.2 * mode.value;
}

Reference referenceOf(const Subject& subject, const std::string& name, const std::string& text,
                      int n, const fs::path& folder) {
    const std::string size = std::to_string(subject.width()) + "x" +
                             std::to_string(subject.height()) + "-" + std::to_string(n);
    const fs::path file =
        folder / (name + "-" + size + "-" + std::to_string(hashOf(text)) + ".floats");
    const std::size_t count =
        3 * static_cast<std::size_t>(subject.width()) * static_cast<std::size_t>(subject.height()) +
        1;
    std::vector<float> numbers = read(file, count);
    if (numbers.empty()) {
        numbers = render(subject, n);
        sw::writeFile(file, std::string(reinterpret_cast<const char*>(numbers.data()),
                                        numbers.size() * sizeof(float)));
    }
    Reference reference{sw::Image(subject.width(), subject.height()),
                        static_cast<double>(numbers.back())};
    std::size_t i = 0;
    for (int y = 0; y < subject.height(); ++y)
        for (int x = 0; x < subject.width(); ++x, i += 3)
            reference.image.at(x, y) = {numbers[i], numbers[i + 1], numbers[i + 2]};
    return reference;
}

Statement stateError(const Subject& subject, const Mode& mode, std::uint64_t seed,
                     const Reference& reference) {
    const auto drawn = [&]() -> sw::RenderResult {
        if (mode.kind == Mode::Kind::grid)
            return subject.uniformly(sw::SamplePattern::jitter, static_cast<int>(mode.value), seed);
        sw::AdaptiveOptions options;
        options.render.seed = seed;
        if (mode.kind == Mode::Kind::tolerance) options.tolerance = static_cast<float>(mode.value);
        if (mode.kind == Mode::Kind::targetRmse)
            options.targetRmse = static_cast<float>(mode.value);
        if (mode.kind == Mode::Kind::timeLimit) options.timeLimit = mode.value;
        return subject.adaptively(options);
    };
    const sw::RenderResult result = drawn();
    return {sw::compare(result.image, reference.image).rmse, result.estimatedRmse,
            result.estimatedRmseStandardError,
            static_cast<double>(result.samples) / subject.width() / subject.height(),
            result.seconds};
}

}  // namespace report
