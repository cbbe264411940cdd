#pragma once

#include <array>
#include <string>
#include <vector>

#include "tools/stability/oracle.h"

namespace report {

template <typename Shape>
struct Case {
    Shape shape;
    sw::Ray ray;
    Truth truth;
};

/// Random cases of one kind, the same in every run. The oracle is certain about all of them.
template <typename Shape>
struct Family {
    std::string name;
    std::vector<Case<Shape>> cases;
};

/// The first family is an ordinary one: about half of its rays hit. Times are measured on it.
std::vector<Family<sw::Sphere>> sphereFamilies(int size);
std::vector<Family<sw::Triangle>> triangleFamilies(int size);

/// Two triangles with a common edge and a ray that must hit at least one of them.
struct EdgeCase {
    std::array<sw::Triangle, 2> triangles;
    sw::Ray ray;
};
EdgeCase edgeCase(int index);

}  // namespace report
