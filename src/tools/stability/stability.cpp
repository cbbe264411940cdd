#include "tools/stability/stability.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>

#include "swFile.h"
#include "tools/common/machine.h"
#include "tools/common/measure.h"
#include "tools/common/tool.h"
#include "tools/stability/cases.h"
#include "tools/stability/methods.h"
#include "tools/stability/stabilityOutput.h"

namespace report {
namespace {

namespace fs = std::filesystem;

struct StabilityOptions {
    fs::path output = "report";
    bool quick = false;
};

struct Effort {
    int cases;        ///< per family
    int edgeRays;     ///< rays aimed at shared edges
    int timedCases;   ///< of the ordinary family: too many for branch prediction to learn
    int repetitions;  ///< of the timing
};
constexpr Effort full{40000, 1000000, 16384, 401};
constexpr Effort quickLook{500, 10000, 512, 5};

// The error of t in units of the true value's last place.
double errorInUlp(float t, const Truth& truth) {
    const float rounded = static_cast<float>(truth.t);
    const long double ulp = std::nextafter(rounded, HUGE_VALF) - rounded;
    return static_cast<double>(std::fabs(static_cast<long double>(t) - truth.t) / ulp);
}

template <typename Shape>
Score score(const Method<Shape>& method, const Family<Shape>& family) {
    Score result{family.name};
    std::size_t wrong = 0;
    for (const Case<Shape>& one : family.cases) {
        sw::Intersection hit;
        const bool found = method.make(one.shape)->intersect(one.ray, hit);
        if (found != one.truth.hit)
            ++wrong;
        else if (found)
            result.largestError = std::max(result.largestError, errorInUlp(hit.hitT, one.truth));
    }
    result.wrongPercent =
        100 * static_cast<double>(wrong) / static_cast<double>(family.cases.size());
    return result;
}

// All families have the same number of cases.
Score combine(const std::vector<Score>& families) {
    Score all{"all"};
    for (const Score& family : families) {
        all.wrongPercent += family.wrongPercent / static_cast<double>(families.size());
        all.largestError = std::max(all.largestError, family.largestError);
    }
    return all;
}

using Primitives = std::vector<std::unique_ptr<sw::Primitive>>;

// Takes the results, so that the compiler cannot drop the computation.
volatile float sink;

// Primitive i meets ray i.
double nanosecondsPerCall(const Primitives& primitives, const std::vector<sw::Ray>& rays) {
    sw::Intersection hit;
    float sum = 0;
    const double seconds = secondsOf([&] {
        for (std::size_t i = 0; i < rays.size(); ++i)
            if (primitives[i]->intersect(rays[i], hit)) sum += hit.hitT;
    });
    sink = sum;
    return 1e9 * seconds / static_cast<double>(rays.size());
}

// Times Primitive::intersect of all methods on the same rays. Repetitions are interleaved as in
// Google Benchmark; each turn takes about a millisecond.
template <typename Shape>
Times timeAll(const std::vector<Method<Shape>>& methods, const Family<Shape>& family,
              const Effort& effort) {
    const auto count = std::min(family.cases.size(), static_cast<std::size_t>(effort.timedCases));
    std::vector<sw::Ray> rays;
    for (std::size_t i = 0; i < count; ++i) rays.push_back(family.cases[i].ray);
    std::vector<Primitives> primitives(methods.size());
    std::vector<std::function<double()>> contestants;
    for (std::size_t k = 0; k < methods.size(); ++k) {
        for (std::size_t i = 0; i < count; ++i)
            primitives[k].push_back(methods[k].make(family.cases[i].shape));
        contestants.emplace_back([&, k] { return nanosecondsPerCall(primitives[k], rays); });
    }
    return Times(effort.repetitions, contestants);
}

template <typename Shape>
std::vector<MethodResult> examine(const std::string& shape,
                                  const std::vector<Method<Shape>>& methods,
                                  const std::vector<Family<Shape>>& families,
                                  const Effort& effort) {
    const Times times = timeAll(methods, families[0], effort);
    std::vector<MethodResult> results;
    for (std::size_t k = 0; k < methods.size(); ++k) {
        MethodResult result{shape, methods[k].name, times.of(k), times.ratio(k, 0), {}, {}, {}};
        for (const auto& family : families) result.families.push_back(score(methods[k], family));
        result.overall = combine(result.families);
        results.push_back(std::move(result));
    }
    return results;
}

double leaksPerMillion(const Method<sw::Triangle>& method, int rays) {
    int leaks = 0;
    for (int i = 0; i < rays; ++i) {
        const EdgeCase edge = edgeCase(i);
        sw::Intersection hit;
        const auto hits = [&](const sw::Triangle& triangle) {
            return method.make(triangle)->intersect(edge.ray, hit);
        };
        if (!hits(edge.triangles[0]) && !hits(edge.triangles[1])) ++leaks;
    }
    return 1e6 * leaks / rays;
}

void run(const StabilityOptions& options) {
    const Effort& effort = options.quick ? quickLook : full;
    const fs::path csv = outputFile(options.output, "stability.csv");

    std::vector<MethodResult> results =
        examine("sphere", sphereMethods(), sphereFamilies(effort.cases), effort);
    const auto methods = triangleMethods();
    auto triangles = examine("triangle", methods, triangleFamilies(effort.cases), effort);
    for (std::size_t k = 0; k < methods.size(); ++k)
        triangles[k].leaksPerMillion = leaksPerMillion(methods[k], effort.edgeRays);
    results.insert(results.end(), triangles.begin(), triangles.end());

    std::cout << machine() << "\n\n" << toTable(results) << "\n";
    sw::writeFile(csv, toCsv(results));
    std::cout << fs::absolute(csv).lexically_normal().string() << "\n"
              << plot(results, options.output) << std::endl;
}

}  // namespace

void addStability(CommandLine line) {
    const auto options = std::make_shared<StabilityOptions>();
    CommandLine command = line.addCommand(
        "stability", "Error against run time of intersection kernels, over hard cases.");
    command.addFolder("-o,--output", options->output, "folder for stability.csv, .svg and .png");
    command.addFlag("--quick", options->quick, "few cases: only check that it works");
    command.setWork([options] { run(*options); });
}

}  // namespace report
