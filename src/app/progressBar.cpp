#include "app/progressBar.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>

#include "app/terminal.h"
#include "nff/plainText.h"

namespace {

constexpr const char* clearLine = "\r\x1b[K";
constexpr double secondsBetween = 0.1;  // two drawings
constexpr double slowTile = 2;          // seconds: now the bar tells the pixel ...
constexpr double verySlowTile = 10;     // ... and where there is no bar, a line does

int percent(double part) {
    return static_cast<int>(100 * std::clamp(part, 0.0, 1.0));
}

// What the numbers say, beside the bar.
std::string inWords(const Progress& p) {
    std::ostringstream text = sw::plainStream();
    text << std::fixed << std::setprecision(1);
    if (p.done) text << std::setw(3) << percent(*p.done) << " %";
    if (p.secondsLeft) text << "  " << *p.secondsLeft << " s left";
    if (!p.done) text << p.seconds << " s";
    if (p.pass > 0) text << "  pass " << p.pass << ", " << percent(p.passDone) << " %";
    text << std::defaultfloat << std::setprecision(2);
    if (p.error) text << "  rmse " << *p.error;
    if (p.targetError > 0) text << " -> " << p.targetError;
    if (p.slowPixel) text << "  at pixel " << p.slowPixel->first << "," << p.slowPixel->second;
    return text.str();
}

}  // namespace

std::string progressLine(const Progress& progress, int width) {
    constexpr int longest = 40, shortest = 5;
    std::string words = inWords(progress);
    const int room = width - 1 - static_cast<int>(words.size()) - 3;
    if (room >= shortest) {
        const int length = std::min(room, longest);
        const double part = progress.done ? *progress.done : progress.passDone;
        const auto full = static_cast<std::size_t>(std::clamp(part, 0.0, 1.0) * length);
        std::string bar(static_cast<std::size_t>(length), ' ');
        std::fill_n(bar.begin(), full, '#');
        words = std::string("[").append(bar).append("] ").append(words);
    }
    return words.substr(0, static_cast<std::size_t>(std::max(width - 1, 0)));
}

ProgressBar::ProgressBar(bool isAdaptive, double timeLimit, double targetError)
    : isTerminal(stderrIsTerminal()), timeLimit(timeLimit) {
    progress.pass = isAdaptive ? 1 : 0;
    progress.targetError = targetError;
}

ProgressBar::~ProgressBar() {
    if (isVisible) std::cerr << clearLine << std::flush;
}

double ProgressBar::since(Clock::time_point time) const {
    return std::chrono::duration<double>(Clock::now() - time).count();
}

void ProgressBar::tilesDone(int done, int total) {
    const std::lock_guard lock(mutex);
    lastTile = Clock::now();
    progress.slowPixel.reset();
    update(static_cast<double>(done) / total);
    if (isTerminal && since(drawn) > secondsBetween) draw();
}

void ProgressBar::passDone(int passes, double error) {
    const std::lock_guard lock(mutex);
    progress.pass = passes + 1;
    progress.passDone = 0;
    progress.error = error;
}

void ProgressBar::inPixel(int x, int y) {
    const std::unique_lock lock(mutex, std::try_to_lock);
    if (!lock) return;
    const double inTile = since(lastTile);
    if (inTile < slowTile) return;
    progress.slowPixel = {x, y};
    if (isTerminal) {
        update(progress.passDone);
        if (since(drawn) > secondsBetween) draw();
    } else if (!hasComplained && inTile > verySlowTile) {
        hasComplained = true;
        std::cerr << "swtracer: pixel " << x << "," << y << " and others beside it take long; "
                  << percent(progress.passDone) << " % of the picture's tiles are done"
                  << std::endl;
    }
}

// Says nothing of what is not known: how many passes will follow, and how long they take.
void ProgressBar::update(double done) {
    progress.seconds = since(start);
    progress.passDone = done;
    if (timeLimit > 0) {
        progress.done = std::min(progress.seconds / timeLimit, 1.0);
        progress.secondsLeft = std::max(timeLimit - progress.seconds, 0.0);
    } else if (progress.pass == 0) {
        progress.done = done;
        if (done > 0) progress.secondsLeft = progress.seconds * (1 - done) / done;
    }
}

void ProgressBar::draw() {
    drawn = Clock::now();
    isVisible = true;
    std::cerr << clearLine << progressLine(progress, terminalWidth()) << std::flush;
}
