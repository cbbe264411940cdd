#pragma once

#include <string>

#include "app/options.h"
#include "app/report.h"
#include "swRenderer.h"
#include "swScene.h"

/// What there is to know about a run, as JSON.
std::string statsJson(const Options& options, const sw::RenderResult& result,
                      const StepTimes& times, const sw::Scene& scene);
