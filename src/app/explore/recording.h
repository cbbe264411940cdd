#pragma once

#include <vector>

#include "app/explore/rayColumns.h"
#include "app/options.h"
#include "swNff.h"

/// The rays behind a picture: of every pixel or, to be done in seconds and to fit into a few
/// megabytes, of every step-th one in either direction.
struct Recording {
    int step = 1;
    int columns = 0, rows = 0;  ///< of recorded pixels; the first is that of the window's corner
    RayColumns rays;
    std::vector<sw::NffShape> shapes;  ///< that a ray hit, first; some others for the view behind
};

/// Records the rays through the pixels' centres.
/// @param options  with a size set by settleSize()
/// @param file     with its camera set up for that size
/// @param shapes   the file's shapes
Recording recordRays(const Options& options, const sw::NffScene& file,
                     std::vector<sw::NffShape> shapes, const rayTree::Trace& traceRay);

/// The page that shows a recording; nothing in it needs a network or another file.
/// @param errors  estimated, of the window's pixels
std::string explorePage(const Options& options, const sw::NffScene& file,
                        const Recording& recording, const sw::Image& errors);
