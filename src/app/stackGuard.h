#pragma once

/// Explains a recursion without end, which fills the stack, where there would be a bare
/// segmentation fault. Costs nothing while all is well. Does nothing where the system is neither
/// Linux nor macOS.
namespace stackGuard {

/// Watches the calling thread's stack from now on.
/// @param x, y  the pixel that is rendered: what to look into
void watch(int x, int y);

}  // namespace stackGuard
