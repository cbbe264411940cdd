// A solution of the lab as students handed it in from 2021 to 2024, written against the original
// swTracer: a guard for the contract that such code compiles unchanged, without a warning, and
// makes our picture. The free style is on purpose; improve it nowhere.

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <memory>
#include <random>

#include "swCamera.h"
#include "swIntersection.h"
#include "swMaterial.h"
#include "swPrimitive.h"
#include "swRay.h"
#include "swScene.h"
#include "swSphere.h"
#include "swTriangle.h"
#include "swVec3.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include "stb_image.h"
#include "stb_image_write.h"

using namespace sw;

inline float clamp(float x, float min, float max) {
    if (x < min) return min;
    if (x > max) return max;
    return x;
}

float uniform() {
    // Will be used to obtain a seed for the random number engine
    static std::random_device rd;
    // Standard mersenne_twister_engine seeded with rd()
    static std::mt19937 gen(rd());
    static std::uniform_real_distribution<float> dis(0.0f, 1.0f);
    return dis(gen);
}

void writeColor(int index, Vec3 p, uint8_t* pixels) {
    // gamma correct for gamma = 2.2
    for (int n = 0; n < 3; n++) {
        p.m[n] = std::pow(p.m[n], 1.0f / 2.2f);
        pixels[index + n] = (uint8_t)(256 * clamp(p.m[n], 0.0f, 0.999f));
    }
}

// my own primitive: the back wall, a rectangle at z = const
class Wall : public Primitive {
public:
    Wall(float x0_, float x1_, float y0_, float y1_, float z_, const Material& m)
        : x0(x0_), x1(x1_), y0(y0_), y1(y1_), z(z_) {
        material = m;
    }

    bool intersect(const Ray& r, Intersection& hit) const override {
        float t = (z - r.origin().z()) / r.direction().z();
        if (!(t > r.minT && t < r.maxT)) return false;
        Vec3 p = r.orig + t * r.dir;
        if (p.x() < x0 || p.x() > x1 || p.y() < y0 || p.y() > y1) return false;
        hit.hitT = t;
        hit.position = p;
        hit.frontFacing = r.dir.z() < 0.0f;
        hit.normal = hit.frontFacing ? Vec3(0.0f, 0.0f, 1.0f) : Vec3(0.0f, 0.0f, -1.0f);
        hit.material = material;
        hit.ray = r;
        return true;
    }

private:
    float x0, x1, y0, y1, z;
};

Color traceRay(const Ray& r, Scene scene, int depth) {
    Color c, directColor, reflectedColor, refractedColor;
    if (depth < 0) return c;

    Intersection hit, shadow;
    if (!scene.intersect(&r, hit)) return Color(0.0f, 0.0f, 0.0f);  // Background color

    const Vec3 lightPos(0.0f, 30.0f, -5.0f);
    Vec3 lightDir = lightPos - hit.position;
    lightDir.normalize();
    hit.normal.normalize();

    // diffuse shading
    float diffuse = hit.normal * lightDir;
    if (diffuse < 0.0f) diffuse = 0.0f;
    directColor = diffuse * hit.material.color;

    // shadow
    Ray shadowRay = hit.getShadowRay(lightPos);
    if (scene.intersect(shadowRay, shadow, true)) directColor *= 0.0f;

    // reflection and refraction
    float reflectivity = hit.material.reflectivity;
    float transparency = hit.material.transparency;
    if (reflectivity > 0.0f) reflectedColor = traceRay(hit.getReflectedRay(), scene, depth - 1);
    if (transparency > 0.0f) refractedColor = traceRay(hit.getRefractedRay(), scene, depth - 1);

    c += (1.0f - reflectivity - transparency) * directColor;
    c += reflectivity * reflectedColor + transparency * refractedColor;
    return c;
}

int main(int argc, char** argv) {
    const int imageWidth = 128;
    const int imageHeight = imageWidth;
    const int numChannels = 3;
    uint8_t* pixels = new uint8_t[imageWidth * imageHeight * numChannels];

    // an argument gives the number of random samples per pixel
    const int samples = argc > 1 ? std::atoi(argv[1]) : 1;

    // Define materials
    Material whiteDiffuse = Material(Color(0.9f, 0.9f, 0.9f), 0.0f, 0.0f, 1.0f);
    Material greenDiffuse = Material(Color(0.1f, 0.6f, 0.1f), 0.0f, 0.0f, 1.0f);
    Material redDiffuse = Material(Color(1.0f, 0.1f, 0.1f), 0.0f, 0.0f, 1.0f);
    Material blueDiffuse = Material(Color(0.0f, 0.2f, 0.9f), 0.0f, 0.0f, 1.0f);
    Material yellowReflective = Material(Color(1.0f, 0.6f, 0.1f), 0.2f, 0.0f, 1.0f);
    Material transparent = Material(Color(1.0f, 1.0f, 1.0f), 0.2f, 0.8f, 1.3f);

    // Setup scene
    Scene scene;

    // Add three spheres with diffuse material
    scene.push(Sphere(Vec3(-7.0f, 3.0f, -20.0f), 3.0f, greenDiffuse));
    scene.push(Sphere(Vec3(0.0f, 3.0f, -20.0f), 3.0f, blueDiffuse));
    scene.push(Sphere(Vec3(7.0f, 3.0f, -20.0f), 3.0f, redDiffuse));

    // Add two reflective and two transparent spheres
    Sphere mirrorBall(Vec3(7.0f, 3.0f, 0.0f), 3.0f, yellowReflective);
    scene.push(mirrorBall);
    mirrorBall.center = Vec3(9.0f, 10.0f, 0.0f);
    scene.push(mirrorBall);
    scene.push(Sphere(Vec3(-7.0f, 3.0f, 0.0f), 3.0f, transparent));
    scene.push(std::make_shared<Sphere>(Vec3(-9.0f, 10.0f, 0.0f), 3.0f, transparent));

    // Define vertices for Cornell box
    Vec3 vertices[] = {Vec3(-20.0f, 0.0f, 50.0f),   Vec3(20.0f, 0.0f, 50.0f),     // Floor 1
                       Vec3(20.0f, 0.0f, -50.0f),                                 //
                       Vec3(-20.0f, 0.0f, 50.0f),   Vec3(20.0f, 0.0f, -50.0f),    // Floor 2
                       Vec3(-20.0f, 0.0f, -50.0f),                                //
                       Vec3(-20.0f, 40.0f, -50.0f), Vec3(20.0f, 40.0f, -50.0f),   // Ceiling 1
                       Vec3(20.0f, 40.0f, 50.0f),                                 //
                       Vec3(-20.0f, 40.0f, -50.0f), Vec3(20.0f, 40.0f, 50.0f),    // Ceiling 2
                       Vec3(-20.0f, 40.0f, 50.0f),                                //
                       Vec3(-20.0f, 0.0f, 50.0f),   Vec3(-20.0f, 0.0f, -50.0f),   // Left wall 1
                       Vec3(-20.0f, 40.0f, -50.0f),                               //
                       Vec3(-20.0f, 0.0f, 50.0f),   Vec3(-20.0f, 40.0f, -50.0f),  // Left wall 2
                       Vec3(-20.0f, 40.0f, 50.0f),                                //
                       Vec3(20.0f, 0.0f, -50.0f),   Vec3(20.0f, 0.0f, 50.0f),     // Right wall 1
                       Vec3(20.0f, 40.0f, 50.0f),                                 //
                       Vec3(20.0f, 0.0f, -50.0f),   Vec3(20.0f, 40.0f, 50.0f),    // Right wall 2
                       Vec3(20.0f, 40.0f, -50.0f)};

    scene.push(Triangle(&vertices[0], whiteDiffuse));
    scene.push(Triangle(&vertices[3], whiteDiffuse));
    scene.push(Triangle(&vertices[6], whiteDiffuse));
    scene.push(Triangle(&vertices[9], whiteDiffuse));
    scene.push(Triangle(&vertices[12], redDiffuse));
    scene.push(Triangle(&vertices[15], redDiffuse));
    scene.push(Triangle(&vertices[18], greenDiffuse));
    scene.push(Triangle(&vertices[21], greenDiffuse));
    scene.push(std::make_shared<Wall>(-20.0f, 20.0f, 0.0f, 40.0f, -50.0f, whiteDiffuse));

    // Setup camera
    Vec3 eye(0.0f, 10.0f, 30.0f);
    Vec3 lookAt(0.0f, 10.0f, -5.0f);
    Vec3 up(0.0f, 1.0f, 0.0f);
    Camera camera(eye, lookAt, up, 52.0f, (float)imageWidth / (float)imageHeight);
    camera.setup(imageWidth, imageHeight);

    // Ray trace pixels
    int depth = 3;
    std::cout << "Rendering... ";
    clock_t start = clock();
    for (int j = 0; j < imageHeight; ++j) {
        for (int i = 0; i < imageWidth; ++i) {
            Color pixel;
            for (int s = 0; s < samples; s++) {
                // Get center of pixel coordinate, or somewhere in the pixel
                float cx = ((float)i) + (samples > 1 ? uniform() : 0.5f);
                float cy = ((float)j) + (samples > 1 ? uniform() : 0.5f);

                // Get a ray and trace it
                Ray r = camera.getRay(cx, cy);
                pixel += traceRay(r, scene, depth);
            }
            pixel = pixel * (1.0f / (float)samples);

            // Write pixel value to image
            writeColor((j * imageWidth + i) * numChannels, pixel, pixels);
        }
    }

    // Save image to file
    stbi_write_png("out.png", imageWidth, imageHeight, numChannels, pixels,
                   imageWidth * numChannels);

    // Free allocated data
    delete[] pixels;
    std::cout << "Done\n";
    std::cout << "Time: " << (double)(clock() - start) / CLOCKS_PER_SEC << " s" << std::endl;
}
