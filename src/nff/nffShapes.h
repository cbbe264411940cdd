#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nff/nffTokens.h"
#include "swNffShape.h"
#include "swScene.h"

namespace sw {

/// What the readers of shapes share: where the text comes from, and where shapes go to.
class NffShapes {
public:
    /// @param list  where not null, shapes are noted there as well
    NffShapes(NffTokens& tokens, Scene& scene, std::vector<NffShape>* list)
        : tokens(tokens), scene(scene), list(list), counted(tokens.begin()) {}

    /// Adds a shape.
    /// @param statement       where its statement begins in the text
    /// @param kind, describe  see NffShape
    template <typename Shape>
    void push(const Shape& shape, const char* statement, const char* kind,
              NffShape::Describe describe) {
        scene.push(shape);
        if (list)
            list->push_back({std::make_shared<Shape>(shape), lineOf(statement), kind, describe});
    }

    /// Reads the vertices of a polygon.
    /// @param withNormals  whether each has a normal behind it
    void readVertices(const char* keyword, bool withNormals, const char* hint);

    /// Notes a shape that is odd and yet can be rendered.
    /// @param kind  of oddity: what is done about it, and what is counted
    void warn(const char* statement, const char* what, const char* kind);

    /// What is odd about the shapes read so far: at most one line for each kind of oddity.
    std::vector<std::string> warnings() const;

    NffTokens& tokens;
    std::vector<Vec3> vertices, normals;  ///< of the last polygon

private:
    struct Oddity {
        const char* kind;
        const char* first;  // where the first one is in the text
        std::string what;   // is wrong with the first one
        int count;
    };

    int lineOf(const char* statement);

    Scene& scene;
    std::vector<NffShape>* list;
    const char* counted;  // up to here ...
    int line = 1;         // ... lines are counted, for the list alone
    std::vector<Oddity> oddities;
};

/// Reads a shape. Takes what follows the keyword, which must be the last token taken.
using ReadShape = void (*)(NffShapes& shapes, const Material& material);

struct ShapeStatement {
    std::string_view keyword;
    ReadShape read;
};

/// The shapes that a scene file may hold.
std::span<const ShapeStatement> shapeStatements();

}  // namespace sw
