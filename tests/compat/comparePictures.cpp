// comparePictures A.png B.png: succeeds if no channel of any pixel differs by more than one step.

#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "files.h"
#include "png.h"

namespace {

int difference(const std::string& a, const std::string& b) {
    const test::PngStructure first(a), second(b);
    if (first.width != second.width || first.height != second.height) return 256;
#if SW_TEST_DECODES_PNG
    const auto p = test::decodePng(a), q = test::decodePng(b);
    if (p.empty() || p.size() != q.size()) return 256;
    int largest = 0;
    for (std::size_t i = 0; i < p.size(); ++i) largest = std::max(largest, std::abs(p[i] - q[i]));
    return largest;
#else
    return a == b ? 0 : 256;
#endif
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    try {
        const int largest = difference(test::contentOf(argv[1]), test::contentOf(argv[2]));
        std::cout << "largest difference: " << largest << " of 255" << std::endl;
        return largest <= 1 ? 0 : 1;
    } catch (const std::exception& error) {
        std::cerr << error.what() << std::endl;
        return 2;
    }
}
