#pragma once

#include "swRay.h"
#include "swVec3.h"

namespace sw {

/// A pinhole camera: turns points of the picture into rays.
class Camera {
public:
    /// @param origin  where the eye is
    /// @param lookAt  the point in the middle of the picture; not equal to origin
    /// @param up      upward direction; any length. If it is (nearly) parallel to the view, the
    ///                coordinate axis least aligned with the view replaces it
    /// @param fov     vertical field of view in degrees, 0 < fov < 180
    /// @param aspect  width / height, until setup() sets the true size
    Camera(const Vec3& origin, const Vec3& lookAt, const Vec3& up, float fov, float aspect = 1);

    /// Sets the picture's size in pixels. Pixels are square at every size.
    void setup(int width, int height);

    /// @param x, y  pixel coordinates: (0,0) is the top left corner of the picture, (width, height)
    ///              the bottom right one; pixel (i,j) has its centre at (i + 0.5, j + 0.5)
    /// @return      the ray from the eye through that point, with a unit direction
    Ray getRay(float x, float y) const;

private:
    Vec3 origin;
    double forward[3];    // unit view direction
    double rightward[3];  // unit, to the right in the picture
    double upward[3];     // unit, upwards in the picture
    double halfHeight;    // of the picture at distance 1: tan(fov / 2)
    double columns;       // of pixels
    double rows = 1;      // of pixels
};

}  // namespace sw
