#pragma once

#include <memory>

namespace sw {
template <typename T>
using ZeroMemory = std::allocator<T>;
}
