#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "handled.h"

// What libFuzzer calls with one text after the other, to find one that crashes the reader or the
// renderer, or is neither rendered nor refused with a good message.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const char* const text = reinterpret_cast<const char*>(data);
    if (!test::isHandled(std::string_view(text, size))) std::abort();
    return 0;
}
