#include "app/program.h"
#include "swSampling.h"

using namespace sw;

// The light that a surface scatters (Lambert, Photometria, 1760). Each light is weighted by the
// cosine of its angle to the normal, and left out if something blocks it.
Color directLight(const Intersection& hit, const Scene& scene) {
    Color sum(0, 0, 0);
    for (const Light& light : scene.lights()) {
        const Vec3 lightDir = (light.position - hit.position).normalize();
        const float cosine = hit.normal * lightDir;
        const Color scattered = hit.material.color.times(light.color);
        if (!(cosine > 0) || scattered.isZero()) continue;  // behind the surface, or black

        if (scene.isOccluded(hit.getShadowRay(light.position))) continue;
        sum += cosine * scattered;
    }
    return sum;
}

// The light that comes back along a ray (Whitted, An Improved Illumination Model for Shaded
// Display, 1980). Rays of weight zero are not traced.
// depth: how many more reflections and refractions may follow; 0: none
Color traceRay(const Ray& ray, const Scene& scene, int depth) {
    Intersection hit;
    if (!scene.intersect(ray, hit)) return scene.background();

    const float r = hit.material.reflectivity;
    const float t = hit.material.transparency;
    Color color(0, 0, 0);
    if (1 - r - t > 0) color += (1 - r - t) * directLight(hit, scene);
    if (r > 0 && depth > 0) color += r * traceRay(hit.getReflectedRay(), scene, depth - 1);
    if (t > 0 && depth > 0) color += t * traceRay(hit.getRefractedRay(), scene, depth - 1);
    return color;
}

// The colour of the pixel whose top left corner is (x, y): the mean of n x n samples, one at a
// random place in each cell of a grid. A single sample goes through the pixel's centre.
Color samplePixel(float x, float y, int n, int depth, const Camera& camera, const Scene& scene) {
    if (n == 1) return traceRay(camera.getRay(x + 0.5f, y + 0.5f), scene, depth);

    SampleMean mean;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const float dx = (i + uniform()) / n;
            const float dy = (j + uniform()) / n;
            mean += traceRay(camera.getRay(x + dx, y + dy), scene, depth);
        }
    }
    return mean;
}

// Loads scene and camera, computes the colour of every pixel, and writes the picture to a file.
// runProgram() reads the command line and reports errors.
int main(int argc, char** argv) {
    return runProgram(argc, argv, [](Run& run) {
        const NffScene& file = run.loadScene();
        run.render(traceRay, [&](int x, int y) {
            return samplePixel(x, y, run.samples(), run.depth(), file.camera, file.scene);
        });
        run.write();
    });
}
