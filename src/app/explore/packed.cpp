#include "app/explore/packed.h"

#include <new>

#include "png/stbMemory.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb_image_write.h>

std::string deflated(std::string_view bytes) {
    if (bytes.empty()) return {};  // of nothing, stb makes a stream without an end
    constexpr int quality = 8;     // stb's own default
    const sw::StbMemory memory;
    std::string input(bytes);
    int length = 0;
    unsigned char* const result =
        stbi_zlib_compress(reinterpret_cast<unsigned char*>(input.data()),
                           static_cast<int>(input.size()), &length, quality);
    if (!result) throw std::bad_alloc();  // its only way to fail
    return {reinterpret_cast<const char*>(result), static_cast<std::size_t>(length)};
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t j = i; j < i + 3; ++j)
            group = group << 8 | (j < bytes.size() ? static_cast<unsigned char>(bytes[j]) : 0u);
        for (int shift = 18; shift >= 0; shift -= 6) text += digits[group >> shift & 63];
    }
    const std::size_t missing = (3 - bytes.size() % 3) % 3;
    return text.replace(text.size() - missing, missing, missing, '=');
}

std::string transposed(const std::vector<std::uint32_t>& values, int bytes) {
    const int unused = 32 - 8 * bytes;  // bits
    std::string result(values.size() * static_cast<std::size_t>(bytes), '\0');
    std::uint32_t before = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        // The sign goes to the lowest bit.
        const auto step = static_cast<std::int32_t>((values[i] - before) << unused) >> unused;
        const auto number =
            static_cast<std::uint32_t>(step) << 1 ^ static_cast<std::uint32_t>(step >> 31);
        before = values[i];
        for (int j = 0; j < bytes; ++j)
            result[static_cast<std::size_t>(j) * values.size() + i] =
                static_cast<char>(number >> 8 * j & 255);
    }
    return result;
}
