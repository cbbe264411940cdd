#include "picture.h"
#include "yardstick.h"

namespace bench {

std::unique_ptr<Yardstick> makeYardstick(const Model&) {
    return nullptr;
}

Radiance embreesPicture(int) {
    return nullptr;
}

}  // namespace bench
