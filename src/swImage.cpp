#include "swImage.h"

#include <cmath>
#include <new>

#include "png/stbMemory.h"
#include "swFile.h"

// Static, so that programs with an stb of their own can link to the library.
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb_image_write.h>

namespace sw {

Image::Image(int width, int height)
    : columns(width),
      rows(height),
      pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

std::uint8_t toByte(float linear, float gamma) {
    if (!(linear > 0)) return 0;  // std::pow of a negative radiance would be NaN
    const float display = std::pow(linear, 1 / gamma);
    return static_cast<std::uint8_t>(256 * (display < 0.999f ? display : 0.999f));
}

std::string encodePng(const Image& image, float gamma) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(3 * static_cast<std::size_t>(image.width()) *
                  static_cast<std::size_t>(image.height()));
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            for (const float channel : image.at(x, y).m) bytes.push_back(toByte(channel, gamma));

    std::string png;
    const StbMemory memory;
    const auto append = [](void* target, void* data, int size) {
        static_cast<std::string*>(target)->append(static_cast<const char*>(data),
                                                  static_cast<std::size_t>(size));
    };
    const int written = stbi_write_png_to_func(append, &png, image.width(), image.height(), 3,
                                               bytes.data(), 3 * image.width());
    if (written == 0) throw std::bad_alloc();  // its only way to fail
    return png;
}

void writePng(const Image& image, const std::filesystem::path& path, float gamma) {
    writeFile(path, encodePng(image, gamma));
}

}  // namespace sw
