#pragma once

#include <optional>
#include <string>
#include <vector>

#include "nff/nffShapes.h"
#include "nff/nffView.h"

namespace sw {

/// Warns of a colour beyond 0..1.
/// @param at  where its statement begins in the text
void warnOfColor(NffShapes& shapes, const char* at, const Color& color);

/// Notes what makes a whole picture black. Every place is where a statement begins in the text.
class NffChecks {
public:
    explicit NffChecks(NffShapes& shapes) : shapes(shapes) { shapes.bounds.emplace(); }

    void view(const NffView& view) { eye = view; }
    void background(const char* at, const Color& color);
    void light(const char* at, const Color& color);
    /// @param material  as the shading uses it
    void material(const char* at, const Material& material);
    /// A shape of the last material follows.
    void shape();

    /// Why nothing can be seen, once all statements have been read: only what is certain at any
    /// size of the picture.
    std::vector<std::string> warnings() const;

private:
    enum Look { black, diffuse, specular };  // specular: it only mirrors or lets through

    bool lacksLight() const;
    bool isAllBehind() const;

    NffShapes& shapes;
    std::optional<NffView> eye;
    Look look = black;                 // of the last material, ...
    const char* materialAt = nullptr;  // ... where it is, ...
    bool isUsed[3] = {};               // ... and which looks the shapes have
    const char* firstUsed = nullptr;   // the first shape's material
    const char* firstLight = nullptr;
    bool isAnyLightOn = false;
    bool isBackgroundBlack = true;
};

}  // namespace sw
