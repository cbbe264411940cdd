#include "tools/convergence/study.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "tools/common/measure.h"
#include "tools/common/subject.h"
#include "tools/common/table.h"

namespace report {
namespace {

struct Method {
    std::string name, setting;
    bool pictured;  // keep a picture of its errors
    bool slow;      // its time is steady, so one run is enough
    std::function<sw::RenderResult(std::uint64_t seed)> draw;
};

std::vector<Method> methodsFor(const Subject& subject, const StudyEffort& effort) {
    std::vector<Method> methods;
    const int pictured = std::min(3, effort.largestGrid);
    for (std::size_t k = 0; k < sw::patternNames.size(); ++k) {
        const auto pattern = static_cast<sw::SamplePattern>(k);
        for (int n = 1; n <= effort.largestGrid; ++n)
            methods.push_back({sw::patternNames[k], std::to_string(n) + "x" + std::to_string(n),
                               n == pictured, n > 5, [&subject, pattern, n](std::uint64_t seed) {
                                   return subject.uniformly(pattern, n, seed);
                               }});
    }
    for (std::size_t i = 0; i < effort.tolerances.size(); ++i) {
        const float tolerance = effort.tolerances[i];
        methods.push_back({"adaptive", rounded(static_cast<double>(tolerance), 6),
                           i == effort.tolerances.size() / 2, false,
                           [&subject, tolerance](std::uint64_t seed) {
                               sw::AdaptiveOptions options;
                               options.tolerance = tolerance;
                               options.render.seed = seed;
                               return subject.adaptively(options);
                           }});
    }
    return methods;
}

// The repetitions of one method: its errors and its times.
class Repetitions {
public:
    void add(const sw::RenderResult& drawn, const sw::Image& reference) {
        const sw::Metrics metrics = sw::compare(drawn.image, reference);
        squares += metrics.rmse * metrics.rmse;
        estimatedSquares += drawn.estimatedRmse * drawn.estimatedRmse;
        visible += metrics.visible;
        if (seconds.empty() || metrics.largest > result.error.largest) result.error = metrics;
        result.rays = static_cast<double>(drawn.rays.total());
        result.samples =
            static_cast<double>(drawn.samples) / drawn.image.width() / drawn.image.height();
        seconds.push_back(drawn.seconds);
    }

    Measurement summary(const Method& method) const {
        const double n = static_cast<double>(seconds.size());
        Measurement all = result;
        all.method = method.name;
        all.setting = method.setting;
        all.seconds = median(seconds);
        all.error.rmse = std::sqrt(squares / n);
        all.error.psnr = -20 * std::log10(all.error.rmse);
        all.error.visible = visible / n;
        all.estimatedRmse = std::sqrt(estimatedSquares / n);
        return all;
    }

private:
    Measurement result;
    std::vector<double> seconds;
    double squares = 0, estimatedSquares = 0, visible = 0;
};

}  // namespace

Study studyScene(const std::filesystem::path& scene, const StudyEffort& effort) {
    const Subject subject(sw::loadNff(scene), effort.size);
    sw::RenderResult reference = subject.reference(effort.referenceGrid);
    const std::vector<Method> methods = methodsFor(subject, effort);
    Study study{scene.stem().string(), std::move(reference.image), reference.estimatedRmse, {}, {}};

    // The methods take turns: if the machine slows down, it does so for all of them alike.
    std::vector<Repetitions> repetitions(methods.size());
    for (int i = 1; i <= effort.repetitions; ++i) {
        for (std::size_t k = 0; k < methods.size(); ++k) {
            if (i > 1 && methods[k].slow) continue;
            const sw::RenderResult drawn = methods[k].draw(static_cast<std::uint64_t>(i));
            repetitions[k].add(drawn, study.reference);
            if (i == 1 && methods[k].pictured)
                study.errors.push_back(
                    {methods[k].name, methods[k].setting,
                     sw::heatMap(sw::absoluteDifference(drawn.image, study.reference))});
        }
    }
    for (std::size_t k = 0; k < methods.size(); ++k)
        study.measurements.push_back(repetitions[k].summary(methods[k]));
    return study;
}

}  // namespace report
