#pragma once

#include "nff/polygon/pointTree.h"
#include "nff/polygon/triangulate.h"

namespace sw {

/// Cuts ears off a polygon until nothing is left. An ear is a corner whose triangle with its two
/// neighbours lies inside the polygon (Meisters, Polygons Have Ears, 1975).
///
/// Cutting one ear changes no other corner but its neighbours, so each cut asks two questions.
/// What may keep a corner from being an ear is found with a tree of the corners that are not
/// convex, so that most questions take about log n steps. Ears that are long and thin, along many
/// other corners, take more: they have to wait for all others, which often clear their way.
class EarCutter {
public:
    /// @param corners  of the polygon, counter-clockwise; must outlive this
    EarCutter(const std::vector<Point2>& corners, Triangulation& result);

    void cutAll();

private:
    void askAll();
    void answerQuestions();
    bool bePatient();
    void dropSpikes();
    void forceOne();
    void cutRestAsFan();

    bool isGone(std::uint32_t corner) const { return next[corner] == corner; }
    double turnAt(std::uint32_t corner) const;
    bool isSpike(std::uint32_t corner) const;
    bool isEar(std::uint32_t corner);
    void cutEar(std::uint32_t corner);
    void drop(std::uint32_t corner);
    void review(std::uint32_t corner);

    const std::vector<Point2>& points;
    Triangulation& out;
    std::vector<std::uint32_t> previous, next;  // the ring of corners that are left
    std::vector<std::uint32_t> questions;       // corners that may be ears, the first one first
    std::size_t answered = 0;
    std::vector<std::uint32_t> postponed;  // questions that took more steps than patience allows
    std::vector<std::uint32_t> spikes;     // corners to drop before any ear is cut
    PointTree blockers;                    // the corners that are left and not convex
    std::size_t left;                      // number of corners that are left
    std::uint32_t last = 0;                // one of them
    std::size_t mostSteps, patience;
};

}  // namespace sw
