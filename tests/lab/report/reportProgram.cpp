#include "lab/report/reportProgram.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <stdexcept>

#include "lab/report/grade.h"
#include "lab/report/makePage.h"
#include "swFile.h"

namespace lab {
namespace {

namespace fs = std::filesystem;

struct WrongUse : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Six whole numbers with commas between them.
std::vector<int> pointsFrom(const std::string& text) {
    constexpr int most = 1'000'000;  // so that they can be added up
    std::vector<int> points;
    const char* at = text.data();
    const char* const end = at + text.size();
    for (bool more = true; more;) {
        int value = -1;
        const auto [next, error] = std::from_chars(at, end, value);
        more = next != end && *next == ',';
        if (error != std::errc() || value < 0 || value > most || (!more && next != end)) break;
        points.push_back(value);
        at = next + 1;
    }
    if (points.size() != 6 || std::count(text.begin(), text.end(), ',') != 5)
        throw WrongUse("expected six whole numbers of points from 0 to " + std::to_string(most) +
                       ", found '" + text + "'");
    return points;
}

void writeGrade(const std::vector<std::string>& arguments, std::ostream& out) {
    const std::string json = grade(results(arguments[1], arguments[2]), pointsFrom(arguments[4]));
    sw::writeFile(arguments[3], json);
    out << json;
}

}  // namespace

int reportProgram(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err) {
    try {
        if (arguments.size() == 4 && arguments[0] == "page")
            makePage(arguments[1], arguments[2], arguments[3]);
        else if (arguments.size() == 5 && arguments[0] == "grade")
            writeGrade(arguments, out);
        else
            throw WrongUse(
                "expected 'page RECORDS PROGRAM PAGE' or 'grade RECORDS PROGRAM JSON POINTS'");
        return 0;
    } catch (const WrongUse& error) {
        err << "lab_report: " << error.what() << "\n";
        return 2;
    } catch (const std::exception& error) {
        err << "lab_report: " << error.what() << "\n";
        return 1;
    }
}

}  // namespace lab
