#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/convergence/study.h"

namespace report {

/// The whole report as one page. Takes the plots (see plotName()) from the folder, where they are.
/// @param all      overview() of the studies
/// @param folder   also takes the pictures as PNG
/// @param remarks  lines of text for the top: where it was measured, what is missing
/// @throws sw::FileError
std::string convergencePage(const std::vector<Study>& studies, const Study& all,
                            const std::filesystem::path& folder,
                            const std::vector<std::string>& remarks);

}  // namespace report
