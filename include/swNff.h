#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "swCamera.h"
#include "swScene.h"

namespace sw {

/// A scene file that cannot be read. The message is `file:line:column: expected ..., found ...`,
/// or `file: reason` where the file as a whole is at fault.
class NffError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// What a scene file describes.
struct NffScene {
    Scene scene;
    Camera camera;  ///< set up for the resolution below
    int width;      ///< default size of the picture in pixels
    int height;
};

/// Reads a scene in Eric Haines' Neutral File Format (Standard Procedural Databases, 1987):
///
///     v                        the view, anywhere in the file; angle is vertical, in degrees
///     from x y z  at x y z  up x y z  angle a  hither h  resolution w h
///     b r g b                  background
///     l x y z [r g b]          point light; lights without a colour get 1/sqrt(number of lights)
///     f r g b Kd Ks Shine T i  material of what follows: reflectivity Ks, transparency T,
///                              refractive index i (ignored where T is 0); Shine is not used.
///                              The diffuse part is Kd * (r, g, b), unless Ks + T is 1 or more
///     s x y z radius           sphere
///     p n  x y z  ...          convex polygon of n vertices, counter-clockwise from its front
///     # ...                    comment until the end of the line
///
/// Any white space separates; the locale does not matter.
/// @param name  what error messages call the text
/// @throws NffError
NffScene parseNff(std::string_view text, const std::string& name);

/// Reads a scene file.
/// @throws NffError
NffScene loadNff(const std::filesystem::path& path);

}  // namespace sw
