#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/options.h"
#include "app/renderWatch.h"
#include "app/report.h"
#include "swRenderer.h"
#include "swScene.h"

/// Renders without the lab's samplePixel(), if the command line asks for that; else returns
/// nothing.
/// @param spent     time that loading and building took, of the time limit
/// @param radiance  colour at a point of the picture
std::optional<sw::RenderResult> renderOtherwise(
    const Options& options, const StepTimes& spent, RenderWatch& watch,
    const std::function<sw::Color(float x, float y)>& radiance);

/// Writes statistics and error image, if the command line asks for them. One that fails does not
/// keep the other from being written.
/// @param failure  what went wrong with the picture; empty: nothing
/// @throws sw::FileError that tells of every failure
void writeExtras(const Options& options, const sw::RenderResult& result, const StepTimes& times,
                 const sw::Scene& scene, std::string failure);
