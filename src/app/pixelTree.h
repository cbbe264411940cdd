#pragma once

#include <string>
#include <vector>

#include "app/options.h"
#include "rayTree/rayProbe.h"
#include "swNff.h"

/// Describes a pixel: its colour, and the tree of rays that starts with the ray through its centre.
/// @param options  with a pixel, and a size set by settleSize()
/// @param file     with its camera set up for that size
/// @param shapes   the file's shapes
std::string describePixel(const Options& options, const sw::NffScene& file,
                          std::vector<sw::NffShape> shapes, const rayTree::Trace& trace);
