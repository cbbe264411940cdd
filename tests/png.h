#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

// Debian's libstb-dev has a decoder; only stb_image_write is vendored. Where there is none, the
// structure of a PNG is all that the tests look at.
#if __has_include(<stb/stb_image.h>)
#define SW_TEST_DECODES_PNG 1
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb/stb_image.h>
#else
#define SW_TEST_DECODES_PNG 0
#endif

namespace test {

/// Size and checksums of an 8-bit RGB PNG.
class PngStructure {
public:
    /// @throws std::runtime_error that says what is wrong with the file
    explicit PngStructure(std::string_view png) : rest(png) {
        require(take(8) == "\x89PNG\r\n\x1a\n", "signature");
        std::string_view type = takeChunk();
        require(type == "IHDR" && body.size() == 13, "header");
        width = number(body.substr(0, 4));
        height = number(body.substr(4, 4));
        require(body.substr(8) == std::string_view("\x08\x02\0\0\0", 5), "8-bit RGB");
        while (type != "IEND") type = takeChunk();
        require(rest.empty(), "end");
    }

    std::uint32_t width = 0, height = 0;

private:
    static void require(bool condition, const char* what) {
        if (!condition) throw std::runtime_error(std::string("PNG: bad ") + what);
    }
    static std::uint32_t number(std::string_view bytes) {
        std::uint32_t value = 0;
        for (const char byte : bytes) value = value << 8 | static_cast<unsigned char>(byte);
        return value;
    }
    // CRC-32 as in the PNG specification, annex D.
    static std::uint32_t checksum(std::string_view bytes) {
        std::uint32_t crc = 0xffffffff;
        for (const char byte : bytes) {
            crc ^= static_cast<unsigned char>(byte);
            for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1 ? 0xedb88320 : 0);
        }
        return ~crc;
    }
    std::string_view take(std::size_t size) {
        require(size <= rest.size(), "length");
        const std::string_view taken = rest.substr(0, size);
        rest.remove_prefix(size);
        return taken;
    }
    std::string_view takeChunk() {
        const std::size_t size = number(take(4));
        const std::string_view typeAndBody = take(size + 4);
        require(number(take(4)) == checksum(typeAndBody), "checksum");
        body = typeAndBody.substr(4);
        return typeAndBody.substr(0, 4);
    }

    std::string_view rest;
    std::string_view body;  // of the last chunk
};

#if SW_TEST_DECODES_PNG
/// The red, green and blue bytes of a PNG, row by row; empty if it cannot be decoded.
inline std::vector<std::uint8_t> decodePng(const std::string& png) {
    int width = 0, height = 0, channels = 0;
    stbi_uc* const pixels =
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(png.data()),
                              static_cast<int>(png.size()), &width, &height, &channels, 3);
    if (!pixels) return {};
    std::vector<std::uint8_t> bytes(pixels, pixels + 3 * width * height);
    stbi_image_free(pixels);
    return bytes;
}
#endif

}  // namespace test
