#include "support.h"

namespace test {

Vec3 Random::direction() {
    for (;;) {
        const dvec3 v(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
        const double length = glm::length(v);
        if (length > 0.01 && length < 1) return sw::num::toFloat(v / length);
    }
}

}  // namespace test
