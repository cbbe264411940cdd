// kit >>>
//| #include <algorithm>
//| #include <cmath>
//|
// From here to `<<<` stands what students do not get; they get what `//|` says instead. See
// kit/regions.h.
// <<<
#include "lab.h"
#include "program.h"
// kit >>>
#include "swErrorEstimate.h"
#include "swRayCount.h"
// <<<
#include "swSampling.h"
// kit >>>
//| #include "todo.h"
// <<<

using namespace sw;

// The light that comes back along a ray (Whitted, An Improved Illumination Model for Shaded
// Display, 1980): scattered light from every light source that the surface sees, and what arrives
// from the mirrored and the refracted direction.
// kit >>>
// No ray is cast whose weight is 0; the statistics count them.
// <<<
// depth: how many more times the ray may be reflected or refracted
Color traceRay(const Ray& ray, const Scene& scene, int depth) {
    Intersection hit;
    if (!scene.intersect(ray, hit)) return scene.background();

    // tasks 1, 3, 4 and 5 >>>
    //| Color scattered(0, 0, 0);
    //| for (const Light& light : scene.lights()) {
    //|     // TODO 3, shadows: pass over a light that something hides from the hit point.
    //|     if (todo::isInShadow(hit, light, scene)) continue;
    //|
    //|     // TODO 1, diffuse shading: in place of white, what Lambert's law says of this light.
    //|     scattered += todo::diffuse(hit, light);
    //| }
    //| Color color = scattered;
    //|
    //| // TODO 4, reflection: a surface of reflectivity r loses r of what it scatters and gains r
    //| // of what the reflected ray brings, as long as the depth allows one.
    //| color += todo::reflection(scattered, hit, scene, depth);
    //|
    //| // TODO 5, refraction: the same with its transparency t and the refracted ray.
    //| color += todo::refraction(scattered, hit, scene, depth);
    //|
    //| return color;
    const Material& material = hit.material;
    const float r = material.reflectivity;
    const float t = material.transparency;
    Color color(0, 0, 0);

    for (const Light& light : scene.lights()) {
        const float cosine = hit.normal * (light.position - hit.position).normalize();
        const Color scattered = material.color.times(light.color);
        if (!(cosine > 0)) {  // or NaN
            leaveOut(LeftOut::shadowFacingAway);
        } else if (!(1 - r - t > 0) || scattered.isZero()) {
            leaveOut(LeftOut::shadowZeroWeight);
        } else if (Intersection blocker;
                   !scene.intersect(hit.getShadowRay(light.position), blocker, true)) {
            color += (1 - r - t) * cosine * scattered;
        }
    }
    if (depth > 0) {
        if (r > 0) color += r * traceRay(hit.getReflectedRay(), scene, depth - 1);
        if (t > 0) color += t * traceRay(hit.getRefractedRay(), scene, depth - 1);
        leaveOut(LeftOut::secondaryZeroWeight, !(r > 0) + !(t > 0));
    }
    return color;
    // <<<
}

// The colour of the pixel whose top left corner is (x, y): the mean of n x n samples, one at a
// random place in each cell of a grid. A single sample goes through the pixel's centre.
Color samplePixel(float x, float y, int n, int depth, const Camera& camera, const Scene& scene) {
    // task 6 >>>
    //| // TODO 6, supersampling: n x n jittered samples in place of one through the centre.
    //| return todo::samplePixel(x, y, n, depth, camera, scene);
    if (n == 1) return traceRay(camera.getRay(x + 0.5f, y + 0.5f), scene, depth);

    const float cells = static_cast<float>(n);
    Color sum(0, 0, 0);
    for (float j = 0; j < cells; ++j) {
        for (float i = 0; i < cells; ++i) {
            const float dx = (i + uniform()) / cells;
            const float dy = (j + uniform()) / cells;
            sum += noteSample(traceRay(camera.getRay(x + dx, y + dy), scene, depth));
        }
    }
    return sum * (1 / (cells * cells));
    // <<<
}

int main(int argc, char** argv) {
    return runProgram(argc, argv);
}
