#include "tools/stability/timing.h"

#include <algorithm>
#include <chrono>

namespace report {
namespace {

// What is computed ends here, so that no compiler may leave it out.
volatile float sink;

double nanosecondsPerCall(const Primitives& primitives, const std::vector<sw::Ray>& rays) {
    sw::Intersection hit;
    float sum = 0;
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < rays.size(); ++i)
        if (primitives[i]->intersect(rays[i], hit)) sum += hit.hitT;
    const std::chrono::duration<double, std::nano> elapsed =
        std::chrono::steady_clock::now() - start;
    sink = sum;
    return elapsed.count() / static_cast<double>(rays.size());
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

std::vector<Timing> timeMethods(const std::vector<Primitives>& methods,
                                const std::vector<sw::Ray>& rays, int repetitions) {
    std::vector<std::vector<double>> times(methods.size()), ratios(methods.size());
    for (int i = 0; i < repetitions; ++i) {
        for (std::size_t k = 0; k < methods.size(); ++k) {
            times[k].push_back(nanosecondsPerCall(methods[k], rays));
            ratios[k].push_back(times[k].back() / times[0].back());
        }
    }
    std::vector<Timing> result;
    for (std::size_t k = 0; k < methods.size(); ++k)
        result.push_back({median(times[k]), median(ratios[k])});
    return result;
}

}  // namespace report
