#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/options.h"
#include "app/renderWatch.h"
#include "app/report.h"
#include "rayTree/rayProbe.h"
#include "swNff.h"
#include "swRenderer.h"
#include "swScene.h"

struct Recording;

/// Renders without the lab's samplePixel(), if the command line asks for that; else returns
/// nothing.
/// @param spent     time that loading and building took, of the time limit
/// @param radiance  colour at a point of the picture
std::optional<sw::RenderResult> renderOtherwise(
    const Options& options, const StepTimes& spent, RenderWatch& watch,
    const std::function<sw::Color(float x, float y)>& radiance);

/// Records the rays of the picture, if the command line asks for that; else returns nothing. Where
/// traceRay() does not end, rendering may crash: then the page is written at once.
/// @param shapes  the file's
std::shared_ptr<const Recording> recordExtras(const Options& options, const sw::NffScene& file,
                                              std::vector<sw::NffShape> shapes,
                                              const rayTree::Trace& traceRay);

/// Writes statistics, error image and the page of rays, if the command line asks for them. One that
/// fails does not keep the others from being written.
/// @param failure  what went wrong with the picture; empty: nothing
/// @throws sw::FileError that tells of every failure
void writeExtras(const Options& options, const sw::RenderResult& result, const StepTimes& times,
                 const sw::NffScene& file, const Recording* recording, std::string failure);
