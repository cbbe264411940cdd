#pragma once

#include <string>

/// Scenes that grow with a size, in Neutral File Format (swNff.h): the constructions of Eric
/// Haines' Standard Procedural Databases (A Proposal for Standard Graphics Environments, IEEE
/// Computer Graphics and Applications 7(11), 1987). The same size always gives the same text.
namespace scenes {

/// A scene generator.
struct Generator {
    const char* name;
    const char* shows;
    int least, most, usual;             ///< sizes; the largest have a million shapes or two
    std::string (*generate)(int size);  ///< least <= size <= most
};

/// A sphere with nine smaller ones on it, each with nine on it and so on, above a ground of one
/// polygon: (9^(size + 1) - 1) / 8 mirroring spheres.
std::string balls(int size);

/// A tetrahedron of tetrahedra of tetrahedra: 4^size equilateral triangles in the cube -1..1.
std::string tetra(int size);

/// A fractal mountain of 2 * 4^size triangles under four spheres of glass.
std::string mount(int size);

/// Layers of 1, 4, 9, ... objects of six rings before a wall; each ring is five cylinders that meet
/// in spheres: 10 size (size + 1) (2 size + 1) shapes.
std::string rings(int size);

/// A tree of forks: 2^(size + 1) - 1 branches, each a cone with a sphere at its end, on a lawn.
std::string tree(int size);

constexpr Generator generators[] = {
    {"balls", "sphereflake: reflection", 0, 6, 4, balls},
    {"tetra", "pyramid of tetrahedra: many hidden surfaces", 1, 10, 6, tetra},
    {"mount", "fractal mountain under glass spheres: refraction", 1, 10, 6, mount},
    {"rings", "interlocked rings of cylinders: reflection, many shadows", 1, 40, 7, rings},
    {"tree", "tree of cones: many lights and shadows", 0, 19, 11, tree},
};

}  // namespace scenes
