#pragma once

#include <chrono>
#include <limits>
#include <mutex>
#include <optional>
#include <string>

/// What is known of a render in progress.
struct Progress {
    double seconds = 0;                 ///< since it began
    std::optional<double> done;         ///< 0..1, of all the work
    std::optional<double> secondsLeft;  ///< if all goes on as before
    int pass = 0;                       ///< of adaptive sampling, the one in work; 0: no passes
    double passDone = 0;                ///< 0..1
    std::optional<double> error;        ///< of the picture, as estimated after the last pass
    double targetError = 0;             ///< 0: none
    std::optional<std::pair<int, int>> slowPixel;  ///< in work since long
};

/// One line for a terminal, of less than `width` characters.
std::string progressLine(const Progress& progress, int width);

/// Says how a render goes on: as a bar on stderr if that is a terminal, which clears itself at the
/// end; else in one line if a tile takes very long. Any thread may call its functions.
class ProgressBar {
public:
    /// @param timeLimit, targetError  of adaptive sampling; 0: none
    ProgressBar(bool isAdaptive, double timeLimit, double targetError);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void tilesDone(int done, int total);
    void passDone(int passes, double error);
    void inPixel(int x, int y);

private:
    using Clock = std::chrono::steady_clock;
    double since(Clock::time_point start) const;
    void update(double done);
    void draw();

    const bool isTerminal;
    const double timeLimit;
    const Clock::time_point start = Clock::now();
    std::mutex mutex;  // guards what follows
    Progress progress;
    Clock::time_point drawn = start, lastTile = start;
    bool isVisible = false, hasComplained = false;
};
