#pragma once

#include <functional>
#include <optional>

#include "app/options.h"
#include "app/renderWatch.h"
#include "app/report.h"
#include "swRenderer.h"
#include "swScene.h"

// The program does nothing beyond the lab.

inline std::optional<sw::RenderResult> renderOtherwise(
    const Options&, const StepTimes&, const RenderWatch&,
    const std::function<sw::Color(float x, float y)>&) {
    return std::nullopt;
}

inline void writeExtras(const Options&, const sw::RenderResult&, const StepTimes&, const sw::Scene&,
                        const std::string&) {}
