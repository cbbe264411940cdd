#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "app/options.h"
#include "app/renderWatch.h"
#include "app/report.h"
#include "rayTree/rayProbe.h"
#include "swNff.h"
#include "swRenderer.h"

// The program does nothing beyond the lab.

struct Recording {};

inline std::optional<sw::RenderResult> renderOtherwise(
    const Options&, const StepTimes&, const RenderWatch&,
    const std::function<sw::Color(float x, float y)>&) {
    return std::nullopt;
}

inline std::shared_ptr<const Recording> recordExtras(const Options&, const sw::NffScene&,
                                                     const std::vector<sw::NffShape>&,
                                                     const rayTree::Trace&) {
    return nullptr;
}

inline void writeExtras(const Options&, const sw::RenderResult&, const StepTimes&,
                        const sw::NffScene&, const Recording*, const std::string&) {}
