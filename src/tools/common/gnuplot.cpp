#include "tools/common/gnuplot.h"

#include <cstdio>
#include <cstdlib>

#include "nff/plainText.h"

namespace report {
namespace {

#ifdef _WIN32
FILE* openPipe(const char* command) {
    return _popen(command, "w");
}
int closePipe(FILE* pipe) {
    return _pclose(pipe);
}
constexpr const char* isInstalled = "gnuplot --version > NUL 2>&1";
constexpr const char* command = "gnuplot";
#else
FILE* openPipe(const char* command) {
    return popen(command, "w");
}
int closePipe(FILE* pipe) {
    return pclose(pipe);
}
constexpr const char* isInstalled = "gnuplot --version > /dev/null 2>&1";
constexpr const char* command = "gnuplot 2> /dev/null";
#endif

// In single quotes, gnuplot takes all text literally; '' is a single quote.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? "''" : std::string(1, c);
    return result + "'";
}

bool draw(const std::string& terminal, const std::filesystem::path& file,
          const std::string& script) {
    FILE* pipe = openPipe(command);
    if (!pipe) return false;
    const std::string all = "set terminal " + terminal + "\nset output " +
                            quoted(file.generic_string()) + "\n" + script;
    const bool sent = std::fwrite(all.data(), 1, all.size(), pipe) == all.size();
    return closePipe(pipe) == 0 && sent;
}

}  // namespace

std::string plotCommands(const std::vector<Curve>& curves) {
    auto data = sw::plainStream(), plot = sw::plainStream();
    for (std::size_t k = 0; k < curves.size(); ++k) {
        data << "$curve" << k << " << EOD\n";
        for (const Point& point : curves[k].points) data << point.x << " " << point.y << "\n";
        data << "EOD\n";
        plot << (k == 0 ? "plot " : ", ") << "$curve" << k << " using 1:2 with " << curves[k].style
             << " title " << quoted(curves[k].title);
    }
    return data.str() + plot.str() + "\n";
}

std::string drawWithGnuplot(const std::string& script, const std::filesystem::path& name, int width,
                            int height) {
    if (std::system(isInstalled) != 0) return "no plot: gnuplot is not installed";
    const std::string size = " size " + std::to_string(width) + "," + std::to_string(height);
    const std::string base = std::filesystem::absolute(name).lexically_normal().string();
    const bool drawn =
        draw("svg background 'white' font 'sans,11'" + size, base + ".svg", script) &&
        draw("pngcairo font 'sans,10'" + size, base + ".png", script);
    return drawn ? base + ".svg and .png" : "no plot: gnuplot failed";
}

}  // namespace report
