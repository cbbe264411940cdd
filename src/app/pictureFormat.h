#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "swImage.h"

/// The forms in which the program writes pictures.
enum class PictureFormat {
    png,  ///< 8 bits per channel, with gamma
    pfm,  ///< linear floats (Debevec, Portable Float Map)
    hdr   ///< linear, 8 bits and a common exponent (Ward, Real Pixels, Graphics Gems II)
};

/// The form that the ending of a name says, in either case: .png, .pfm or .hdr; else nothing.
std::optional<PictureFormat> formatOf(const std::filesystem::path& file);

/// Whether a file's first bytes are those of one of the forms.
bool isPicture(const std::string& start);

/// The bytes of a picture file.
/// @param gamma  of a PNG
std::string encode(const sw::Image& image, PictureFormat format, float gamma);

/// Bytes that a picture file of this size has at least.
std::uintmax_t leastSize(PictureFormat format, int width, int height);
