#pragma once

#include <string_view>

/// page.html with its style and scripts, as CMake has put it together (explore.cmake). The data of
/// a recording takes the place of "<!-- data -->".
std::string_view pageTemplate();
