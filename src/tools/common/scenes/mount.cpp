#include "tools/common/scenes/scenes.h"

#include <cmath>
#include <random>
#include <vector>

#include "tools/common/nffText.h"

namespace scenes {
namespace {

// Heights over a square grid by midpoint displacement (Fournier, Fussell and Carpenter, Computer
// Rendering of Stochastic Models, 1982).
class Mountain {
public:
    explicit Mountain(int size) : side(1 << size), heights(index(0, side + 1)) {
        // A surface of fractal dimension 2.2: half the distance has 2^-(3 - 2.2) of the height.
        const double roughness = std::exp2(2.2 - 3);
        double displacement = 0.4;
        for (int half = side / 2; half > 0; half /= 2, displacement *= roughness)
            displace(half, displacement);
    }

    void write(NffText& text) const {
        for (int j = 0; j < side; ++j) {
            for (int i = 0; i < side; ++i) {
                text.triangle(point(i, j), point(i + 1, j), point(i + 1, j + 1));
                text.triangle(point(i, j), point(i + 1, j + 1), point(i, j + 1));
            }
        }
    }

private:
    // Sets the heights of the points halfway between those already set.
    void displace(int half, double most) {
        for (int j = 0; j <= side; j += half) {
            for (int i = 0; i <= side; i += half) {
                // Between two neighbours in a row or column (each counts twice), or among four.
                const int x = i / half % 2 * half, y = j / half % 2 * half;
                if (x == 0 && y == 0) continue;
                const double sum = height(i - x, j - y) + height(i + x, j - y) +
                                   height(i - x, j + y) + height(i + x, j + y);
                height(i, j) = sum / 4 + most * noise();
            }
        }
    }

    // In -1..1. The standard defines this generator's numbers, but not those of its distributions.
    double noise() { return static_cast<double>(random()) * 0x1p-31 - 1; }

    double& height(int i, int j) { return heights[index(i, j)]; }
    std::size_t index(int i, int j) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(side + 1) +
               static_cast<std::size_t>(i);
    }
    dvec3 point(int i, int j) const {
        return {2.0 * i / side - 1, 2.0 * j / side - 1, heights[index(i, j)]};
    }

    int side;  // of the grid, in cells
    std::vector<double> heights;
    std::mt19937 random{1989};  // a mountain that fills as much of the picture as Haines' does
};

}  // namespace

std::string mount(int size) {
    NffText text({-1.6, 1.6, 1.7}, {0, 0, 0}, {0, 0, 1});
    text.light({-100, -100, 100});
    text.material({0.5, 0.45, 0.35}, 1, 0);
    Mountain(size).write(text);
    text.material({1, 1, 1}, 0.1, 0.1, 0.9, 1.5);
    for (const double x : {-1., 1.})
        for (const double y : {-1., 1.})  // at four corners of a cube that share no edge
            text.sphere(dvec3(-0.75, 0.75, 1) + 0.17 * dvec3(x, y, x * y), 0.17);
    return text.take();
}

}  // namespace scenes
