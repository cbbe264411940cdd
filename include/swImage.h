#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "swVec3.h"
#include "swZeroMemory.h"

namespace sw {

/// A picture in linear radiance; (0,0) is the top left pixel.
class Image {
public:
    /// A black picture. Width and height are at least 1.
    Image(int width, int height);

    int width() const { return columns; }
    int height() const { return rows; }

    Color& at(int x, int y) { return pixels[index(x, y)]; }
    const Color& at(int x, int y) const { return pixels[index(x, y)]; }

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(x);
    }

    int columns;
    int rows;
    std::vector<Color, ZeroMemory<Color>> pixels;
};

/// A channel's linear radiance as a display shows it: clamped to 0..1. NaN becomes 0.
inline float clampToDisplay(float linear) {
    return linear > 0 ? (linear < 1 ? linear : 1) : 0;
}

/// 8-bit value of one channel: 256 * clamp(linear^(1/gamma), 0, 0.999).
/// Negative radiance and NaN become 0.
std::uint8_t toByte(float linear, float gamma = 2.2f);

/// The bytes of an 8-bit RGB PNG.
std::string encodePng(const Image& image, float gamma = 2.2f);

/// Writes an 8-bit RGB PNG, whole or not at all (see writeFile).
/// @throws FileError
void writePng(const Image& image, const std::filesystem::path& path, float gamma = 2.2f);

}  // namespace sw
