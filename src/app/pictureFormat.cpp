#include "app/pictureFormat.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <vector>

#include "png/stbMemory.h"

// Static: the library has its own.
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb_image_write.h>

namespace {

void append(void* target, void* data, int size) {
    static_cast<std::string*>(target)->append(static_cast<const char*>(data),
                                              static_cast<std::size_t>(size));
}

// Rows from the bottom up, three floats a pixel, bytes in the machine's order: the scale's sign.
std::string encodePfm(const sw::Image& image) {
    constexpr bool little = std::endian::native == std::endian::little;
    std::string bytes = "PF\n" + std::to_string(image.width()) + " " +
                        std::to_string(image.height()) + (little ? "\n-1.0\n" : "\n1.0\n");
    for (int y = image.height(); y-- > 0;)
        for (int x = 0; x < image.width(); ++x)
            bytes.append(reinterpret_cast<const char*>(image.at(x, y).m), sizeof image.at(x, y).m);
    return bytes;
}

// The format holds neither NaN nor negative numbers, which become 0, nor more than 2^127.
float storable(float linear) {
    return linear > 0 ? std::min(linear, 0x1p126f) : 0;
}

std::string encodeHdr(const sw::Image& image) {
    std::vector<float> floats;
    floats.reserve(3 * static_cast<std::size_t>(image.width()) *
                   static_cast<std::size_t>(image.height()));
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            for (const float channel : image.at(x, y).m) floats.push_back(storable(channel));
    std::string bytes;
    const sw::StbMemory memory;
    stbi_write_hdr_to_func(append, &bytes, image.width(), image.height(), 3, floats.data());
    return bytes;
}

}  // namespace

std::optional<PictureFormat> formatOf(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (ending == ".png") return PictureFormat::png;
    if (ending == ".pfm") return PictureFormat::pfm;
    if (ending == ".hdr") return PictureFormat::hdr;
    return std::nullopt;
}

bool isPicture(const std::string& start) {
    for (const char* signature : {"\x89PNG\r\n\x1a\n", "PF\n", "Pf\n", "#?RADIANCE\n", "#?RGBE\n"})
        if (start.compare(0, std::char_traits<char>::length(signature), signature) == 0)
            return true;
    return false;
}

std::string encode(const sw::Image& image, PictureFormat format, float gamma) {
    if (format == PictureFormat::pfm) return encodePfm(image);
    if (format == PictureFormat::hdr) return encodeHdr(image);
    return sw::encodePng(image, gamma);
}

// PNG: Deflate packs 258 bytes into two bits at best. HDR: 127 equal bytes into two.
std::uintmax_t leastSize(PictureFormat format, int width, int height) {
    const auto pixels = static_cast<std::uintmax_t>(width) * static_cast<std::uintmax_t>(height);
    if (format == PictureFormat::pfm) return 12 * pixels;
    return format == PictureFormat::hdr ? pixels * 4 * 2 / 127 : pixels * 3 / 1032;
}
