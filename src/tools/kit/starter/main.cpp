#include <algorithm>
#include <cmath>

#include "app/program.h"
#include "swSampling.h"

using namespace sw;

// The light that comes back along a ray (Whitted, An Improved Illumination Model for Shaded
// Display, 1980).
// depth: how many more reflections and refractions may follow; 0: none
Color traceRay(const Ray& ray, const Scene& scene, int depth) {
    Intersection hit;
    if (!scene.intersect(ray, hit)) return scene.background();

    Color scattered(0, 0, 0);
    for (const Light& light : scene.lights()) {
        const Vec3 lightDir = (light.position - hit.position).normalize();

        // TODO 3, shadows: pass over a light that something hides from the hit point.

        // TODO 1, diffuse shading: in place of white, what Lambert's law says of this light.
        scattered += Color(1, 1, 1);
    }
    Color color = scattered;

    // TODO 4, reflection: a surface of reflectivity r loses r of what it scatters and gains r of
    // what the reflected ray brings, as long as the depth allows one.

    // TODO 5, refraction: the same with its transparency t and the refracted ray.

    return color;
}

// The colour of the pixel whose top left corner is (x, y).
Color samplePixel(float x, float y, int n, int depth, const Camera& camera, const Scene& scene) {
    // TODO 6, supersampling: the mean of n x n jittered samples in place of one through the centre.
    return traceRay(camera.getRay(x + 0.5f, y + 0.5f), scene, depth);
}

// Scene and camera, the colour of every pixel, and the picture into a file. runProgram() reads the
// command line, and says what went wrong.
int main(int argc, char** argv) {
    return runProgram(argc, argv, [](Run& run) {
        const NffScene& file = run.loadScene();
        run.render(traceRay, [&](int x, int y) {
            return samplePixel(x, y, run.samples(), run.depth(), file.camera, file.scene);
        });
        run.write();
    });
}
