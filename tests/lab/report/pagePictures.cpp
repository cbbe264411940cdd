#include "lab/report/pagePictures.h"

#include <cstdint>

#include "swFile.h"
#include "tools/common/html.h"

namespace lab {
namespace {

namespace fs = std::filesystem;

// In pixels, from a PNG's header; 0 if it is none.
std::uint32_t widthOf(const std::string& png) {
    constexpr std::size_t at = 16;
    std::uint32_t width = 0;
    for (std::size_t i = at; i < at + 4 && i < png.size(); ++i)
        width = width << 8 | static_cast<unsigned char>(png[i]);
    return width;
}

std::string percent(int pixel, std::uint32_t width) {
    const std::uint32_t tenths = (2 * static_cast<std::uint32_t>(pixel) + 1) * 500 / width;
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + "%";
}

// Around the worst pixel. Margins in percent count in widths, and so does the picture's height.
std::string ring(const PictureRecord& picture, std::uint32_t width) {
    if (picture.steps == 0 || width == 0) return "";
    return "<span class=\"ring\" style=\"left:" + percent(picture.x, width) +
           ";margin-top:" + percent(picture.y, width) + "\"></span>";
}

std::string shot(const PictureRecord& picture, const fs::path& file, const std::string& caption) {
    try {
        const std::string figure = html::figure(file, caption, "");
        return "<div class=\"shot\">" + ring(picture, widthOf(sw::readFile(file))) + figure +
               "</div>\n";
    } catch (const sw::FileError&) {
        return "<div class=\"shot\">" + html::escaped(caption) + ": the picture is missing</div>\n";
    }
}

std::string largestError(const PictureRecord& picture) {
    if (picture.steps == 0) return "The same in every pixel.";
    return "Largest difference: " + std::to_string(picture.steps) + " of 255, in pixel (" +
           std::to_string(picture.x) + ", " + std::to_string(picture.y) +
           "), counted from the top left. The ring marks it.";
}

}  // namespace

std::string picturesOf(const Record& record, const fs::path& records) {
    std::string html;
    for (const PictureRecord& picture : record.pictures)
        html += "<div class=\"pictures\">\n" +
                shot(picture, records / picture.expected, "expected") +
                shot(picture, records / picture.got, "yours") +
                shot(picture, records / picture.difference, "difference, amplified") +
                "</div>\n<p class=\"quiet\">" + html::escaped(picture.name) + ": " +
                largestError(picture) + "</p>\n";
    return html;
}

}  // namespace lab
