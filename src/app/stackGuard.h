#pragma once

/// Explains a recursion without end in place of a bare segmentation fault. Costs nothing while all
/// is well; on systems other than Linux and macOS, does nothing.
namespace stackGuard {

/// Watches the calling thread's stack from now on.
/// @param x, y  the pixel that is rendered: what to look into
void watch(int x, int y);

}  // namespace stackGuard
