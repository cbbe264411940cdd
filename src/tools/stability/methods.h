#pragma once

#include <memory>
#include <string>
#include <vector>

#include "swSphere.h"
#include "swTriangle.h"

namespace report {

/// One way to intersect a shape. All are called through Primitive::intersect and fill the whole
/// hit record, so that their times are comparable.
template <typename Shape>
struct Method {
    std::string name;
    std::unique_ptr<sw::Primitive> (*make)(const Shape& shape);
};

/// The original's formula comes first, the library's own last.
std::vector<Method<sw::Sphere>> sphereMethods();
std::vector<Method<sw::Triangle>> triangleMethods();

}  // namespace report
