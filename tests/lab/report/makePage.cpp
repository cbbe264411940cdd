#include "lab/report/makePage.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <iomanip>
#include <optional>
#include <sstream>

#include "lab/report/page.h"
#include "swFile.h"

namespace lab {
namespace {

namespace fs = std::filesystem;

// When the last test ran, in local time; empty if none has.
std::string lastRun(const std::vector<Task>& tasks) {
    std::optional<fs::file_time_type> last;
    for (const Task& task : tasks)
        for (const Outcome& outcome : task.outcomes)
            if (outcome.state != Outcome::State::notRun)
                last = std::max(last.value_or(outcome.record.when), outcome.record.when);
    if (!last) return "";
    // Two clocks with a start of their own: what both know is how long ago it was.
    using std::chrono::system_clock;
    const auto ago = std::chrono::duration_cast<system_clock::duration>(
        fs::file_time_type::clock::now() - *last);
    const std::time_t time = system_clock::to_time_t(system_clock::now() - ago);
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << std::put_time(std::localtime(&time), "%d %B %Y, %H:%M:%S");
    return text.str();
}

}  // namespace

void makePage(const fs::path& records, const fs::path& program, const fs::path& file) {
    const auto tasks = results(records, program);
    const fs::path whole = fs::absolute(file);
    fs::create_directories(whole.parent_path());
    sw::writeFile(whole, page(tasks, records, lastRun(tasks)));
}

}  // namespace lab
