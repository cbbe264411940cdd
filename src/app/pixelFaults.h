#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "swImage.h"

/// Pixels whose colour no picture can show.
struct PixelFaults {
    struct Kind {
        std::size_t count = 0;
        int x = 0, y = 0;  ///< the first one, row by row
    };
    Kind notFinite;  ///< NaN or infinite in some channel
    Kind negative;   ///< and finite
    int black = 0;   ///< which is no fault unless all pixels are
};

PixelFaults findFaults(const sw::Image& image);

/// One line for each kind of fault that there is.
/// @param x0, y0  where the image begins in the whole picture
std::vector<std::string> describeFaults(const sw::Image& image, int x0, int y0);
