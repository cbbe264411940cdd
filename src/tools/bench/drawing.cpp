#include "tools/bench/drawing.h"

#include <cmath>
#include <stdexcept>

#include "swRenderer.h"
#include "tools/common/mainFunctions.h"
#include "tools/common/measure.h"

namespace bench {
namespace {

// Mean difference of two pictures' channels.
double difference(const sw::Image& a, const sw::Image& b) {
    double sum = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            for (int i = 0; i < 3; ++i)
                sum += std::fabs(static_cast<double>(sw::clampToDisplay(a.at(x, y)[i]) -
                                                     sw::clampToDisplay(b.at(x, y)[i])));
    return sum / (3.0 * a.width() * a.height());
}

}  // namespace

double Drawing::draw(int threads) {
    return report::secondsOf([&] { paint(threads); });
}

double Drawing::drawAlone() {
    return report::processorSecondsOf([&] { paint(1); });
}

void Drawing::paint(int threads) {
    const sw::Window all{0, 0, image.width(), image.height()};
    image = sw::render(all, radiance, {.threads = threads}).image;
}

void requireSamePicture(const sw::Image& ours, const sw::Image& other, const std::string& name,
                        double most) {
    const double d = difference(ours, other);
    if (!(d < most))
        throw std::runtime_error("the picture of " + name + " differs from ours by " +
                                 std::to_string(d) + " on average; expected less than " +
                                 std::to_string(most));
}

Radiance ourPicture(sw::NffScene file, int size, int samples, int depth) {
    file.camera.setup(size, size);
    file.scene.prepare();
    return [file = std::move(file), samples, depth](int x, int y) {
        return lab::samplePixel(static_cast<float>(x), static_cast<float>(y), samples, depth,
                                file.camera, file.scene);
    };
}

}  // namespace bench
