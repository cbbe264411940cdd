#include "app/pixelFaults.h"

#include <cmath>

namespace {

void count(PixelFaults::Kind& kind, int x, int y) {
    if (kind.count++ > 0) return;
    kind.x = x;
    kind.y = y;
}

}  // namespace

PixelFaults findFaults(const sw::Image& image) {
    PixelFaults faults;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const sw::Color& c = image.at(x, y);
            const float sum = c[0] + c[1] + c[2];
            faults.black += c.isZero();
            if (!std::isfinite(sum))
                count(faults.notFinite, x, y);
            else if (c[0] < 0 || c[1] < 0 || c[2] < 0)
                count(faults.negative, x, y);
        }
    return faults;
}

std::vector<std::string> describeFaults(const sw::Image& image, int x0, int y0) {
    std::vector<std::string> lines;
    const auto add = [&](const PixelFaults::Kind& kind, const char* what) {
        if (kind.count == 0) return;
        const std::string place = std::to_string(kind.x + x0) + "," + std::to_string(kind.y + y0);
        lines.push_back("warning: " + std::to_string(kind.count) +
                        (kind.count == 1 ? " pixel is " : " pixels are ") + what +
                        ", the first at " + place + "; to see its rays: --pixel " + place);
    };
    const PixelFaults faults = findFaults(image);
    add(faults.notFinite, "NaN or infinite");
    add(faults.negative, "negative");
    if (faults.black == image.width() * image.height())
        lines.push_back("warning: every pixel is black; to see why: --pixel " +
                        std::to_string(x0 + image.width() / 2) + "," +
                        std::to_string(y0 + image.height() / 2));
    return lines;
}
