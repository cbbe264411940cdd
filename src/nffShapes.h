#pragma once

#include <string>
#include <vector>

#include "nffTokens.h"
#include "swNff.h"

namespace sw {

/// Reads the shapes of a scene file into a scene. Each function takes what follows its keyword,
/// which must be the last token taken.
class NffShapes {
public:
    /// @param list  where not null, shapes are noted there as well
    NffShapes(NffTokens& source, Scene& target, std::vector<NffShape>* list)
        : tokens(source), scene(target), listed(list), counted(source.begin()) {}

    void readSphere(const Material& material);   ///< s
    void readCone(const Material& material);     ///< c
    void readPolygon(const Material& material);  ///< p
    void readPatch(const Material& material);    ///< pp

    /// What is odd about the shapes read so far: at most one line for each kind of oddity.
    std::vector<std::string> warnings() const;

private:
    /// Shapes that are odd in the same way.
    struct Oddity {
        const char* first = nullptr;  ///< where the first one is in the text
        std::string what;             ///< is wrong with the first one
        int count = 0;

        void note(const char* at, const char* reason);
    };

    int readVertexCount(const char* keyword);
    void readVertices(const NffTokens::Group& group, bool withNormals);
    template <typename PushTriangle>
    void cut(const char* statement, const PushTriangle& pushTriangle);
    Patch patch(std::size_t a, std::size_t b, std::size_t c, const Material& material) const;
    template <typename Shape>
    void push(const Shape& shape, const char* statement);

    NffTokens& tokens;
    Scene& scene;
    std::vector<NffShape>* listed;
    const char* counted;                  // up to here ...
    int line = 1;                         // ... lines are counted, for the list alone
    std::vector<Vec3> vertices, normals;  // of the polygon being read
    Oddity unclearPolygons, flatCones;
};

}  // namespace sw
