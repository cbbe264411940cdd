#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nff/nffTokens.h"
#include "swNffShape.h"
#include "swScene.h"

namespace sw {

/// Shared by the readers of shapes: the tokens that they read and the scene that they fill.
class NffShapes {
public:
    /// @param list  if not null, all shapes are appended to it as well
    NffShapes(NffTokens& tokens, Scene& scene, std::vector<NffShape>* list)
        : tokens(tokens), scene(scene), list(list), counted(tokens.begin()) {}

    /// Adds a shape.
    /// @param statement       where its statement begins in the text
    /// @param kind, describe  see NffShape
    template <typename Shape>
    void push(const Shape& shape, const char* statement, const char* kind,
              NffShape::Describe describe) {
        scene.push(shape);
        if (bounds) bounds->add(shape.bounds());
        if (list)
            list->push_back({std::make_shared<Shape>(shape), lineOf(statement), kind, describe});
    }

    /// Reads the vertices of a polygon.
    /// @param withNormals  whether a normal follows each vertex
    void readVertices(const char* keyword, bool withNormals, const char* hint);

    /// Records a shape that is odd but can be rendered.
    /// @param what  is wrong with this shape
    /// @param kind  of oddity: how it is handled, and what is counted
    void warn(const char* statement, const std::string& what, const char* kind);

    /// Counts one more, if that kind was recorded before: saves describing it.
    bool warnAgain(const char* kind);

    /// Warnings about the shapes read so far: at most one line for each kind of oddity.
    std::vector<std::string> warnings() const;

    NffTokens& tokens;
    std::vector<Vec3> vertices, normals;  ///< of the last polygon
    std::optional<Bounds> bounds;         ///< of all shapes, if set before the first

private:
    struct Oddity {
        std::string_view kind;
        const char* first;  // where the first one is in the text
        std::string what;   // is wrong with the first one
        int count;
    };

    int lineOf(const char* statement);

    Scene& scene;
    std::vector<NffShape>* list;
    const char* counted;  // lines are counted up to here, ...
    int line = 1;         // ... only for the list
    std::vector<Oddity> oddities;
};

/// Reads a shape after its keyword, which must be the last token taken.
using ReadShape = void (*)(NffShapes& shapes, const Material& material);

struct ShapeStatement {
    std::string_view keyword;
    ReadShape read;
};

/// The shapes that a scene file may hold.
std::span<const ShapeStatement> shapeStatements();

}  // namespace sw
