#pragma once

#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include "support.h"
#include "swNff.h"

/// Scene files to try, and what the reader says about them.
namespace test {

/// A camera at (0, 0, 5) that looks along -z.
const std::string view = "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 90\nhither 1\nresolution 8 4\n";
const std::string grey = "f 0.5 0.5 0.5 1 0 0 0 1\n";

/// What a file holds that begins with the view.
inline sw::NffScene parse(const std::string& statements) {
    return sw::parseNff(view + statements, "test.nff");
}

/// The material of what stands at the origin.
inline sw::Material materialOf(const std::string& statements) {
    sw::Intersection hit;
    REQUIRE(parse(statements).scene.intersect(sw::Ray(Vec3(0, 0, 5), Vec3(0, 0, -1)), hit));
    return hit.material;
}

/// Numbers as they are spelt in a file, each with a space behind it.
inline std::string text(double number) {
    std::ostringstream out;
    out << std::setprecision(9) << number << ' ';
    return out.str();
}
inline std::string text(const Vec3& v) {
    return text(v[0]) + text(v[1]) + text(v[2]);
}

/// What the reader says about a.nff, or "" if it likes it.
inline std::string nffErrorOf(const std::string& file) {
    try {
        sw::parseNff(file, "a.nff");
    } catch (const sw::NffError& error) {
        return error.what();
    }
    return "";
}

struct ErrorCase {
    std::string text, message;
};

/// The texts of error cases follow a good view, a light and a material, which end with line 2.
const std::string good =
    "v from 0 0 5 at 0 0 0 up 0 1 0 angle 45 hither 1 resolution 8 8 l 0 0 99\n"
    "f 1 1 1 1 0 0 0 1\n";

/// Each text must be refused with its message, which begins with line and column.
inline void checkErrors(const std::vector<ErrorCase>& cases, const std::string& before = good) {
    for (const ErrorCase& c : cases) {
        CAPTURE(c.text);
        CHECK(nffErrorOf(before + c.text) == "a.nff:" + c.message);
    }
}

/// What the reader warns of after the same good beginning.
inline std::vector<std::string> warningsOf(const std::string& statements,
                                           const std::string& before = good) {
    return sw::parseNff(before + statements, "a.nff").warnings;
}

}  // namespace test
