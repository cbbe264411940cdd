#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "swFile.h"
#include "tools/bench/drawing.h"
#include "tools/bench/parts.h"
#include "tools/bench/povrayScene.h"
#include "tools/common/command.h"
#include "tools/common/scenes/scenes.h"

namespace bench {
namespace {

constexpr int depth = 4;  // as in Haines' rules for these scenes

// A binary PPM with 16 bits per channel; comments may follow the first word.
sw::Image readPpm(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string word;
    int size[3] = {};
    file >> word;
    for (int& number : size) {
        while ((file >> std::ws).peek() == '#')
            file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
        file >> number;
    }
    file.get();
    if (!file || word != "P6" || size[2] != 65535)
        throw std::runtime_error(path.string() + ": expected a PPM with 16 bits per channel");
    sw::Image image(size[0], size[1]);
    for (int y = 0; y < size[1]; ++y) {
        for (int x = 0; x < size[0]; ++x) {
            for (float& channel : image.at(x, y).m) {
                const int high = file.get(), low = file.get();
                channel = static_cast<float>(256 * high + low) / 65535;
            }
        }
    }
    if (!file) throw std::runtime_error(path.string() + ": expected more pixels");
    return image;
}

// The time that it says it traced: without reading the scene and building its tree.
double traceSeconds(const std::string& output) {
    const auto line = output.find("Trace Time:");
    const auto with = output.find("thread(s) with ", line);
    if (line == std::string::npos || with == std::string::npos)
        throw std::runtime_error("POV-Ray's output names no trace time:\n" + output);
    std::istringstream rest(output.substr(with + 15));
    double seconds = 0;
    rest >> seconds;
    return seconds;
}

// Renders a scene with POV-Ray, in files of its own.
class PovRay {
public:
    PovRay(const Setup& setup, const std::string& scene, int size)
        : folder(setup.output), pixels(std::to_string(size)) {
        sw::writeFile(folder / "povray.pov", scene);
    }
    ~PovRay() {
        std::error_code ignored;
        for (const char* file : {"povray.pov", "povray.ppm"})
            std::filesystem::remove(folder / file, ignored);
    }
    PovRay(const PovRay&) = delete;
    PovRay& operator=(const PovRay&) = delete;

    double draw() const {
        return traceSeconds(
            report::outputOf("povray +Ipovray.pov +Opovray.ppm +FP16 File_Gamma=1.0 -A -D +WT1 +W" +
                                 pixels + " +H" + pixels,
                             folder));
    }
    sw::Image picture() const { return readPpm(folder / "povray.ppm"); }

private:
    std::filesystem::path folder;
    std::string pixels;
};

void compare(const Setup& setup, const scenes::Generator& generator, Lines& lines) {
    const int size = setup.quick ? 64 : 512;
    const std::string text = generator.generate(setup.quick ? generator.least : generator.usual);
    std::vector<sw::NffShape> shapes;
    const sw::NffScene file = sw::parseNff(text, generator.name, &shapes);
    const PovRay povRay(setup, povrayScene(file, shapes, depth), size);
    Drawing ours(ourPicture(file, size, 1, depth), size);
    const Times times(setup.repetitions(3),
                      {[&] { return ours.drawAlone(); }, [&] { return povRay.draw(); }});
    requireSamePicture(ours.image, povRay.picture(), "POV-Ray", 0.0005);
    lines.push_back({std::string(generator.name) + ", 1 thread", "POV-Ray 3.7", "s", times.of(0),
                     times.of(1), times.ratio(1, 0), Target{Target::atLeast, 4}});
}

}  // namespace

bool isPovRayInstalled() {
    return report::isInstalled("povray");
}

void comparePovRay(const Setup& setup, Lines& lines) {
    if (!isPovRayInstalled()) return;
    for (const scenes::Generator& generator : scenes::generators) compare(setup, generator, lines);
}

}  // namespace bench
