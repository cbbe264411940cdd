#include "nff/polygon/earCutter.h"

namespace sw {
namespace {

// Bounds the work. Long ears across the boxes of scattered corners look at about sqrt(n) of them;
// no simple polygon in triangulateTest.cpp takes half of this. Where sides cross, the result is a
// best effort anyway, and less work is spent on it.
std::size_t mostStepsFor(std::size_t corners, bool isSimple) {
    const auto root = static_cast<std::size_t>(std::sqrt(static_cast<double>(corners)));
    return corners * (isSimple ? 256 + 2 * root : 64);
}

// Whether corner x, with the neighbours before and after, keeps triangle t from being an ear. x
// lies inside t or on its edge.
bool blocks(const Point2 (&t)[3], const Point2& x, const Point2& before, const Point2& after) {
    bool isOn[3];
    for (int i = 0; i < 3; ++i) isOn[i] = orientation(t[i], t[(i + 1) % 3], x) == 0;
    // Inside, or on the cut. One on the cut would lie on an edge of two triangles.
    if (!isOn[0] && !isOn[1]) return true;
    // On a side or at a corner x only touches t, unless the polygon goes on inside.
    const auto leadsInside = [&](const Point2& to) {
        for (int i = 0; i < 3; ++i)
            if (isOn[i] && !(orientation(t[i], t[(i + 1) % 3], to) > 0)) return false;
        return true;
    };
    return leadsInside(before) || leadsInside(after);
}

}  // namespace

EarCutter::EarCutter(const std::vector<Point2>& corners, Triangulation& result)
    : points(corners),
      out(result),
      previous(corners.size()),
      next(corners.size()),
      blockers(corners),
      left(corners.size()),
      mostSteps(mostStepsFor(left, result.simple)),
      patience(16 * static_cast<std::size_t>(std::bit_width(left))) {
    const auto count = static_cast<std::uint32_t>(left);
    for (std::uint32_t i = 0; i < count; ++i) {
        previous[i] = i == 0 ? count - 1 : i - 1;
        next[i] = i + 1 == count ? 0 : i + 1;
    }
    for (std::uint32_t i = 0; i < count; ++i) review(i);
}

void EarCutter::cutAll() {
    for (;;) {
        answerQuestions();
        if (left < 3) return;
        out.simple = false;
        if (out.steps >= mostSteps) return cutRestAsFan();
        forceOne();
        askAll();
    }
}

void EarCutter::askAll() {
    questions.clear();
    postponed.clear();
    answered = 0;
    std::uint32_t corner = last;
    do questions.push_back(corner);
    while ((corner = next[corner]) != last);
}

void EarCutter::answerQuestions() {
    while (left >= 3 && out.steps < mostSteps) {
        dropSpikes();
        if (answered == questions.size() && !bePatient()) return;
        const std::uint32_t corner = questions[answered++];
        if (!isGone(corner) && isEar(corner)) cutEar(corner);
    }
}

void EarCutter::dropSpikes() {
    while (!spikes.empty() && left >= 3) {
        const std::uint32_t corner = spikes.back();
        spikes.pop_back();
        if (!isGone(corner) && isSpike(corner)) drop(corner);
    }
}

// Asks again what took too long to answer. Meanwhile the polygon has become simpler.
bool EarCutter::bePatient() {
    patience *= 4;
    questions.clear();
    answered = 0;
    questions.swap(postponed);
    return !questions.empty();
}

// Goes on where a polygon that crosses itself has no ears left.
void EarCutter::forceOne() {
    std::uint32_t corner = last;
    for (std::size_t i = 0; i < left; ++i, corner = next[corner])
        if (turnAt(corner) > 0) return cutEar(corner);
    cutRestAsFan();
}

void EarCutter::cutRestAsFan() {
    while (left >= 3) cutEar(next[last]);
}

double EarCutter::turnAt(std::uint32_t corner) const {
    return orientation(points[previous[corner]], points[corner], points[next[corner]]);
}

// Where the outline turns back on itself or stands still.
bool EarCutter::isSpike(std::uint32_t corner) const {
    if (turnAt(corner) != 0) return false;
    const Point2 &p = points[previous[corner]], &x = points[corner], &n = points[next[corner]];
    return (p.x - x.x) * (n.x - x.x) + (p.y - x.y) * (n.y - x.y) >= 0;
}

bool EarCutter::isEar(std::uint32_t corner) {
    if (!(turnAt(corner) > 0)) return false;
    const std::uint32_t p = previous[corner], n = next[corner];
    const Point2 triangle[3] = {points[p], points[corner], points[n]};
    const auto keepsFrom = [&](std::uint32_t x) {
        return x != p && x != n &&
               blocks(triangle, points[x], points[previous[x]], points[next[x]]);
    };
    const std::size_t most = out.steps + patience;
    const bool isKept = blockers.any(triangle, keepsFrom, out.steps, most);
    if (out.steps >= most) postponed.push_back(corner);
    return !isKept;
}

void EarCutter::cutEar(std::uint32_t corner) {
    out.triangles.push_back({previous[corner], corner, next[corner]});
    drop(corner);
}

void EarCutter::drop(std::uint32_t corner) {
    const std::uint32_t p = previous[corner], n = next[corner];
    next[p] = n;
    previous[n] = p;
    next[corner] = corner;
    last = p;
    --left;
    if (blockers.isOn(corner)) blockers.set(corner, false);
    review(p);
    review(n);
}

// To be called for a corner that has got new neighbours.
void EarCutter::review(std::uint32_t corner) {
    const bool isConvex = turnAt(corner) > 0;
    if (blockers.isOn(corner) == isConvex) blockers.set(corner, !isConvex);
    if (isSpike(corner)) spikes.push_back(corner);
    questions.push_back(corner);
}

}  // namespace sw
