#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/convergence/study.h"

namespace report {

/// The whole report as one page. Embeds the plots (see plotName()) that it finds in the folder.
/// @param all      overview() of the studies
/// @param folder   the pictures are written here as PNG, too
/// @param remarks  lines for the top of the page: where it was measured, what is missing
/// @throws sw::FileError
std::string convergencePage(const std::vector<Study>& studies, const Study& all,
                            const std::filesystem::path& folder,
                            const std::vector<std::string>& remarks);

}  // namespace report
