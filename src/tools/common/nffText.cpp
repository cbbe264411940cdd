#include "tools/common/nffText.h"

#include <charconv>

namespace scenes {

NffText::NffText(const dvec3& from, const dvec3& at, const dvec3& up) : text("v\n") {
    statement("from", {from}, {});
    statement("at", {at}, {});
    statement("up", {up}, {});
    text += "angle 45\nhither 0.01\nresolution 512 512\n";
    statement("b", {{0.078, 0.361, 0.753}}, {});
}

void NffText::statement(const char* word, Points points, Numbers numbers) {
    text += word;
    for (const dvec3& p : points) append(p);
    for (const double number : numbers) append(number);
    text += '\n';
}

void NffText::append(double number) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, static_cast<float>(number)).ptr;
    text += ' ';
    text.append(digits, end);
}

}  // namespace scenes
