#include "swMetrics.h"

#include <algorithm>
#include <cmath>

namespace sw {
namespace {

double meanSquare(const Color& v) {
    double sum = 0;
    for (const double channel : v.m) sum += channel * channel;
    return sum / 3;
}

// Five colours, one per power of ten from 0.0001 to 1.
Color heat(double value) {
    static const Color colors[] = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}};
    if (std::isnan(value)) return {0.2f, 0.2f, 0.2f};
    const double place = std::clamp(std::log10(value) + 4, 0.0, 4.0);  // log10(0) is -infinity
    const int lower = std::min(static_cast<int>(place), 3);
    const auto share = static_cast<float>(place - lower);
    return (1 - share) * colors[lower] + share * colors[lower + 1];
}

template <typename Action>
void forEachPixel(const Image& image, const Action& action) {
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) action(x, y);
}

}  // namespace

double codeValue(float linear, float gamma) {
    return 256 * static_cast<double>(std::pow(clampToDisplay(linear), 1 / gamma));
}

Metrics compare(const Image& a, const Image& b, float gamma) {
    Metrics result;
    double squares = 0, codeSquares = 0;
    int visible = 0;
    forEachPixel(a, [&](int x, int y) {
        double most = 0;
        for (int i = 0; i < 3; ++i) {
            const float p = a.at(x, y)[i], q = b.at(x, y)[i];
            const double difference =
                std::fabs(static_cast<double>(clampToDisplay(p)) - clampToDisplay(q));
            const double codeDifference = codeValue(p, gamma) - codeValue(q, gamma);
            squares += difference * difference;
            codeSquares += codeDifference * codeDifference;
            most = std::max(most, difference);
        }
        if (most > 2.0 / 255) ++visible;
        if (most > result.largest) {
            result.largest = most;
            result.x = x;
            result.y = y;
        }
    });
    const double pixels = static_cast<double>(a.width()) * a.height();
    result.rmse = std::sqrt(squares / (3 * pixels));
    result.psnr = -20 * std::log10(result.rmse);
    result.visible = visible / pixels;
    result.rmse8bit = std::sqrt(codeSquares / (3 * pixels));
    return result;
}

double estimatedRmse8bit(const Image& image, const Image& errors, float gamma) {
    double squares = 0;
    forEachPixel(image, [&](int x, int y) {
        for (int i = 0; i < 3; ++i) {
            const float mean = clampToDisplay(image.at(x, y)[i]), error = errors.at(x, y)[i];
            const double difference = codeValue(mean, gamma) - codeValue(mean - error, gamma);
            squares += std::isnan(error) ? NAN : difference * difference;
        }
    });
    return std::sqrt(squares / (3.0 * image.width() * image.height()));
}

Image heatMap(const Image& errors) {
    Image map(errors.width(), errors.height());
    forEachPixel(
        errors, [&](int x, int y) { map.at(x, y) = heat(std::sqrt(meanSquare(errors.at(x, y)))); });
    return map;
}

Image absoluteDifference(const Image& a, const Image& b) {
    Image result(a.width(), a.height());
    forEachPixel(a, [&](int x, int y) {
        for (int i = 0; i < 3; ++i)
            result.at(x, y)[i] =
                std::fabs(clampToDisplay(a.at(x, y)[i]) - clampToDisplay(b.at(x, y)[i]));
    });
    return result;
}

}  // namespace sw
