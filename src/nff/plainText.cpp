#include "nff/plainText.h"

#include <cmath>
#include <locale>

namespace sw {

std::ostringstream plainStream() {
    std::ostringstream stream;
    stream.imbue(std::locale::classic());
    return stream;
}

std::string plainText(float number) {
    if (std::isnan(number)) return "nan";  // with either sign
    std::ostringstream stream = plainStream();
    stream << number + 0.0f;
    return stream.str();
}

std::string plainText(const Vec3& v) {
    std::string text("(");
    for (int i = 0; i < 3; ++i) text.append(plainText(v[i])).append(i < 2 ? ", " : ")");
    return text;
}

}  // namespace sw
