// swtracer-counted SCENE SIZE SAMPLES DEPTH: traces a square picture in one thread and prints how
// many rays that took. `swtracer-bench instructions` counts its instructions.
#include <cstdlib>
#include <iostream>

#include "swNff.h"
#include "swRayCount.h"
#include "swSampling.h"
#include "tools/common/mainFunctions.h"

// Only what happens in here is counted.
[[gnu::noinline]] void countedPicture(const sw::NffScene& file, int size, int samples, int depth) {
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            sw::seedPixel(1, x, y);
            lab::samplePixel(static_cast<float>(x), static_cast<float>(y), samples, depth,
                             file.camera, file.scene);
        }
    }
}

int main(int argc, char** argv) {
    if (argc != 5) return 2;
    const int size = std::atoi(argv[2]);
    sw::NffScene file = sw::loadNff(argv[1]);
    file.camera.setup(size, size);
    file.scene.prepare();
    sw::takeRayCount();
    countedPicture(file, size, std::atoi(argv[3]), std::atoi(argv[4]));
    std::cout << "rays " << sw::takeRayCount().total() << std::endl;
}
