#pragma once

#include <string>
#include <string_view>

namespace sw {

/// What may be wrong with a token that was not understood: " (a no-break space, U+00A0: type a
/// plain space)" for example. Empty if there is nothing to say.
std::string hintAbout(std::string_view token);

}  // namespace sw
