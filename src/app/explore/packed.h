#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// RFC 1950: what DecompressionStream("deflate") of a browser reads. Of no bytes: none.
std::string deflated(std::string_view bytes);

/// RFC 4648, section 4, with padding.
std::string base64(std::string_view bytes);

/// Numbers of a column as bytes that deflate well: differences of neighbours, small ones near 0
/// whatever their sign, first the lowest byte of all of them, then the next.
/// @param bytes  of each number, 1 to 4
std::string transposed(const std::vector<std::uint32_t>& values, int bytes);
