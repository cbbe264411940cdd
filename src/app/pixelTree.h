#pragma once

#include <string>
#include <vector>

#include "app/options.h"
#include "rayTree/rayProbe.h"
#include "swNff.h"

/// Says what is behind a pixel: its colour, and the tree of rays from the one through its centre.
/// @param options  with a pixel, and a size that is settled
/// @param file     whose camera is set up for that size
/// @param shapes   those of the file
std::string describePixel(const Options& options, const sw::NffScene& file,
                          std::vector<sw::NffShape> shapes, const rayTree::Trace& trace);
