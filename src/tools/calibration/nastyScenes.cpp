#include "tools/calibration/nastyScenes.h"

#include <cmath>

#include "nff/plainText.h"
#include "swSampling.h"

namespace report {
namespace {

/// Writes a scene that is seen from (0, 0, 5), in the square of half side 1.6 at z = 0.
class Sheet {
public:
    /// @param light  radiance of what is white
    explicit Sheet(double light = 1) {
        sw::seedPixel(16, 0, 0);
        text << "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 35.4893433\nhither 0\n"
                "resolution 64 64\nb 0 0 0\nl 0 0 500 "
             << light << " " << light << " " << light << "\n";
        grey(1);
    }
    void grey(double value) {
        text << "f " << value << " " << value << " " << value << " 1 0 0 0 0\n";
    }
    void rectangle(double x0, double y0, double x1, double y1, double z = 0) {
        text << "p 4\n";
        const double corners[][2] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
        for (const auto& c : corners) text << c[0] << " " << c[1] << " " << z << "\n";
    }
    void ball(double x, double y, double radius) {
        text << "s " << x << " " << y << " 0 " << radius << "\n";
    }
    void hair(double x0, double x1, double radius) {
        text << "c " << x0 << " -1.6 0 " << radius << " " << x1 << " 1.6 0 " << radius << "\n";
    }
    /// n x n balls, each at a random place in its cell.
    void balls(int n, double radius) {
        const double cell = 3.2 / n;
        for (int i = 0; i < n * n; ++i) {
            const double x = i % n + static_cast<double>(sw::uniform());
            const double y = i / n + static_cast<double>(sw::uniform());
            ball(cell * x - 1.6, cell * y - 1.6, radius);
        }
    }
    void wall() { rectangle(-2, -2, 2, 2, -0.1); }
    std::string string() const { return text.str(); }

private:
    std::ostringstream text = sw::plainStream();
};

std::string dashes() {
    Sheet sheet;
    for (int row = 0; row < 30; ++row)
        for (int column = 0; column < 8; ++column) {
            const double x = -1.5 + 0.4 * column, y = -1.5 + 0.1 * row;
            sheet.rectangle(x, y, x + 0.3, y + 0.01);
        }
    return sheet.string();
}

std::string dots(double radius, int n = 8, double light = 1) {
    Sheet sheet(light);
    sheet.balls(n, radius);
    return sheet.string();
}

std::string darkDots() {
    Sheet sheet;
    sheet.wall();
    sheet.grey(0);
    sheet.balls(8, 0.012);
    return sheet.string();
}

std::string hairs() {
    Sheet sheet;
    for (int i = 0; i < 15; ++i) sheet.hair(-1.55 + 0.213 * i, -1.5 + 0.213 * i, 0.004);
    return sheet.string();
}

// Of lines a fifth of a pixel apart, in a picture of 128 x 128.
std::string lattice() {
    Sheet sheet;
    for (double x = -1.0; x < 1; x += 0.005) sheet.rectangle(x, -1, x + 0.0015, 1);
    return sheet.string();
}

// Details in one corner alone; the rest is empty.
std::string corner() {
    Sheet sheet;
    for (int i = 0; i < 400; ++i) sheet.ball(1.2 + 0.018 * (i % 20), 1.2 + 0.018 * (i / 20), 0.002);
    return sheet.string();
}

// Dust on a wall: nearly its colour.
std::string dust() {
    Sheet sheet;
    sheet.wall();
    sheet.grey(0.7);
    sheet.balls(60, 0.004);
    return sheet.string();
}

// Faint hairs beside a busy pattern, which takes all samples.
std::string mixed() {
    Sheet sheet;
    for (double x = -1.5; x < 0; x += 0.06) sheet.rectangle(x, -1.5, x + 0.03, 1.5);
    for (int i = 0; i < 60; ++i)
        sheet.ball(0.2 + 1.2 * static_cast<double>(sw::uniform()),
                   3 * static_cast<double>(sw::uniform()) - 1.5, 0.005);
    return sheet.string();
}

}  // namespace

std::vector<NastyScene> nastyScenes() {
    return {{"dashes", dashes()},
            {"dots-0.003", dots(0.003)},
            {"dots-0.0125", dots(0.0125)},
            {"dots-0.025", dots(0.025)},
            {"dots-0.1", dots(0.1)},
            {"specks", dots(0.006, 16, 20)},
            {"dark-dots", darkDots()},
            {"hairs", hairs()},
            {"lattice", lattice()},
            {"fooling-corner", corner()},
            {"fooling-dust", dust()},
            {"fooling-mixed", mixed()},
            {"fooling-needles", dots(0.0008, 40)},
            {"fooling-suns", dots(0.002, 12, 500)}};
}

}  // namespace report
