#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "swCamera.h"
#include "swNffError.h"
#include "swNffShape.h"
#include "swScene.h"

namespace sw {

/// The content of a scene file.
struct NffScene {
    Scene scene;
    Camera camera;  ///< set up for the resolution below
    int width;      ///< default size of the picture in pixels
    int height;
    /// Things that are odd but can be rendered: `file:line:column: warning: ...`, one warning for
    /// each kind, at its first occurrence.
    std::vector<std::string> warnings;
};

/// Reads a scene in Eric Haines' Neutral File Format (Standard Procedural Databases, 1987):
///
///     v                        the view, anywhere in the file; angle is vertical, in degrees
///     from x y z  at x y z  up x y z  angle a  [hither h]  [resolution w h]
///     b r g b                  background
///     l x y z [r g b]          point light; lights without a colour get 1/sqrt(number of lights)
///     f r g b Kd Ks Shine T i  material of the shapes below: reflectivity Ks, transparency T,
///                              refractive index i (ignored where T is 0); Shine is not used.
///                              The diffuse part is Kd * (r, g, b); beside one, Ks and T that
///                              add up to 1 or more are reduced to just below 1
///     s x y z radius           sphere
///     c x y z r  x y z r       cone or cylinder without caps: base, its radius, apex, its radius
///     p n  x y z  ...          planar polygon of n vertices, counter-clockwise from its front
///     pp n  x y z nx ny nz ... patch: the same, with a normal at each vertex for smooth shading
///     # ...                    comment until the end of the line
///
/// Any white space separates; the locale does not matter. A # begins no comment where it touches a
/// number. The text may be UTF-8, UTF-16 or UTF-32, with any line ends. If a radius is negative,
/// only the inside can be seen. Polygons can be seen from both sides (the format says: from the
/// front alone), have up to 10,000 vertices, need not be convex, and may repeat vertices. What is
/// odd but can be rendered gives a warning, and so does a picture that can only be black.
/// @param name    the text's name in error messages
/// @param shapes  if not null, all shapes are appended to it, in the file's order. The scene itself
///                does not record where its shapes come from
/// @throws NffError
NffScene parseNff(std::string_view text, const std::string& name,
                  std::vector<NffShape>* shapes = nullptr);

/// Reads a scene file.
/// @throws NffError
NffScene loadNff(const std::filesystem::path& path, std::vector<NffShape>* shapes = nullptr);

}  // namespace sw
