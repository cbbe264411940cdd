#include "lab/teach.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "lab/record.h"
#include "swFile.h"

namespace lab {
namespace {

namespace fs = std::filesystem;

// In the picture of the difference, so that one step of 8 bits can be seen.
constexpr int amplification = 8;

// A picture as the screen shows it: 3 bytes a pixel, row by row.
struct Bytes {
    int width = 0, height = 0;
    std::vector<std::uint8_t> values;

    int at(int x, int y, int channel) const {
        return values[static_cast<std::size_t>(3 * (y * width + x) + channel)];
    }
};

Bytes shown(const sw::Image& image) {
    Bytes bytes{image.width(), image.height(), {}};
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            for (const float channel : image.at(x, y).m)
                bytes.values.push_back(sw::toByte(channel));
    return bytes;
}

// To be written with gamma 1, which keeps the bytes.
sw::Image asImage(const Bytes& bytes) {
    sw::Image image(bytes.width, bytes.height);
    const auto value = [&](int x, int y, int channel) {
        return (static_cast<float>(bytes.at(x, y, channel)) + 0.5f) / 256;
    };
    for (int y = 0; y < bytes.height; ++y)
        for (int x = 0; x < bytes.width; ++x)
            image.at(x, y) = {value(x, y, 0), value(x, y, 1), value(x, y, 2)};
    return image;
}

// A binary portable pixmap as toPpm() writes it: without comments.
Bytes fromPpm(const fs::path& path) {
    const std::string ppm = sw::readFile(path);
    Bytes bytes;
    int most = 0, header = 0;
    const int found =
        std::sscanf(ppm.c_str(), "P6 %d %d %d%n", &bytes.width, &bytes.height, &most, &header);
    const std::string::size_type begin = static_cast<std::string::size_type>(header) + 1;
    constexpr int widest = 4096;
    if (found != 3 || most != 255 || bytes.width < 1 || bytes.width > widest || bytes.height < 1 ||
        bytes.height > widest ||
        ppm.size() != begin + static_cast<std::size_t>(bytes.width) *
                                  static_cast<std::size_t>(bytes.height) * 3)
        throw std::runtime_error(path.string() +
                                 ": expected an 8-bit PPM picture (P6), found something else; "
                                 "is the file as it was handed out?");
    bytes.values.assign(ppm.begin() + static_cast<std::string::difference_type>(begin), ppm.end());
    return bytes;
}

std::string toPpm(const Bytes& bytes) {
    return "P6\n" + std::to_string(bytes.width) + " " + std::to_string(bytes.height) + "\n255\n" +
           std::string(bytes.values.begin(), bytes.values.end());
}

// How two pictures of the same size differ.
struct Difference {
    int x = 0, y = 0, steps = 0;  // where a channel is farthest off, and how far
    int beyond = 0;               // pixels with more than the tolerance
    Bytes amplified;
};

Difference difference(const Bytes& a, const Bytes& b, int tolerance) {
    Difference d;
    d.amplified = {a.width, a.height, {}};
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            int worst = 0;
            for (int channel = 0; channel < 3; ++channel) {
                const int steps = std::abs(a.at(x, y, channel) - b.at(x, y, channel));
                worst = std::max(worst, steps);
                d.amplified.values.push_back(
                    static_cast<std::uint8_t>(std::min(255, amplification * steps)));
            }
            if (worst > d.steps) d.x = x, d.y = y, d.steps = worst;
            if (worst > tolerance) ++d.beyond;
        }
    return d;
}

std::string colorAt(const Bytes& bytes, int x, int y) {
    char digits[64];
    std::snprintf(digits, sizeof digits, "(%d, %d, %d)", bytes.at(x, y, 0), bytes.at(x, y, 1),
                  bytes.at(x, y, 2));
    return digits;
}

bool recording() {
    return std::getenv("SW_LAB_RECORD_PICTURES") != nullptr;  // NOLINT: no thread changes it
}

// Leaves the three pictures for the report.
void keep(const std::string& name, const Bytes& expected, const Bytes& got, const Difference& d) {
    const fs::path folder(SW_LAB_RECORDS);
    fs::create_directories(folder);
    const PictureRecord record{
        name,   name + "-expected.png", name + "-got.png", name + "-difference.png", d.x, d.y,
        d.steps};
    sw::writePng(asImage(expected), folder / record.expected, 1);
    sw::writePng(asImage(got), folder / record.got, 1);
    sw::writePng(asImage(d.amplified), folder / record.difference, 1);
    running().pictures.push_back(record);
}

}  // namespace

void fail(const Lesson& lesson) {
    Record& record = running();
    record.tried = lesson.tried;
    record.got = lesson.got;
    record.expected = lesson.expected;
    record.hint = lesson.hint;
    const std::string hint = lesson.hint.empty() ? "" : "\nhint: " + lesson.hint;
    FAIL("tried: " << lesson.tried << "\ngot: " << lesson.got << "\nexpected: " << lesson.expected
                   << hint);
    std::abort();  // never reached: FAIL throws
}

std::string text(float number) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.4g", static_cast<double>(number == 0 ? 0 : number));
    return digits;
}

std::string text(const sw::Vec3& v) {
    std::string all = "(";  // += as GCC 12 warns of "(" + std::string without need
    all += text(v[0]);
    for (const int i : {1, 2}) all += ", " + text(v[i]);
    return all += ")";
}

std::string faultOf(const sw::Vec3& v) {
    for (const float x : v.m)
        if (std::isnan(x))
            return "NaN, which is no number: it comes from 0 / 0, from the root of a negative "
                   "number, or from calculating with another NaN";
    for (const float x : v.m)
        if (std::isinf(x)) return "infinite: it comes from a division by 0, or an overflow";
    return "";
}

std::string faultOfColor(const sw::Color& color) {
    for (const float x : color.m)
        if (x < 0) return "negative: no light is less than none";
    return faultOf(color);
}

void expectPicture(const std::string& name, const sw::Image& picture, int tolerance, int strays,
                   const PictureLesson& lesson) {
    const fs::path file = fs::path(SW_LAB_PICTURES) / (name + ".ppm");
    const Bytes got = shown(picture);
    if (recording()) sw::writeFile(file, toPpm(got));
    const Bytes expected = fromPpm(file);
    if (expected.width != got.width || expected.height != got.height)
        throw std::runtime_error(file.string() + ": expected a picture of " +
                                 std::to_string(got.width) + " x " + std::to_string(got.height) +
                                 " pixels; record it anew");
    const Difference d = difference(expected, got, tolerance);
    keep(name, expected, got, d);
    if (d.beyond <= strays) return;
    const std::string pixel = "pixel (" + std::to_string(d.x) + ", " + std::to_string(d.y) + ")";
    fail({lesson.tried + ", as a picture",
          pixel + " shows the colour " + colorAt(got, d.x, d.y) + " of 0..255; " +
              std::to_string(d.beyond) + " of " + std::to_string(got.width * got.height) +
              " pixels are wrong",
          colorAt(expected, d.x, d.y) + " in " + pixel + "; see " + name + " in the lab report",
          lesson.hint});
}

bool RayWitness::intersect(const sw::Ray& ray, sw::Intersection&) const {
    rays.push_back(ray);
    if (static_cast<int>(rays.size()) >= most) throw TooManyRays();
    return false;
}

}  // namespace lab
