#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <functional>
#include <utility>
#include <vector>

namespace report {

template <typename Work>
double secondsOf(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Processor time: for one thread's work this is steadier than wall time on a shared machine.
template <typename Work>
double processorSecondsOf(const Work& work) {
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// The median of an odd number of values.
inline double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Times of several contestants that take turns: if the machine slows down, it does so for all of
/// them alike.
class Times {
public:
    /// @param contestants  each returns the time that it took, in any unit
    Times(int repetitions, const std::vector<std::function<double()>>& contestants)
        : times(contestants.size()) {
        for (int i = 0; i < repetitions; ++i)
            for (std::size_t k = 0; k < contestants.size(); ++k)
                times[k].push_back(contestants[k]());
    }

    /// Adds one that takes as long as two of them together. Returns its number.
    std::size_t sum(std::size_t a, std::size_t b) {
        std::vector<double> both = times[a];
        for (std::size_t i = 0; i < both.size(); ++i) both[i] += times[b][i];
        times.push_back(std::move(both));
        return times.size() - 1;
    }

    /// Median time of a contestant.
    double of(std::size_t k) const { return median(times[k]); }

    /// Median over the repetitions of the ratio of two contestants' times.
    double ratio(std::size_t of, std::size_t to) const {
        std::vector<double> ratios;
        for (std::size_t i = 0; i < times[of].size(); ++i)
            ratios.push_back(times[of][i] / times[to][i]);
        return median(ratios);
    }

private:
    std::vector<std::vector<double>> times;
};

}  // namespace report
