#pragma once

#include "app/console.h"
#include "app/options.h"
#include "swImage.h"

// The program writes one picture, a PNG.

inline Options checkFiles(const Options& options) {
    if (options.output.extension() == ".png" && options.output != options.scene) return options;
    throw UsageError("-o: expected a new name that ends in .png, found " + options.output.string());
}

inline void requireOutputs(const Options& options) {
    sw::requireWritable(options.output);
}

inline std::string savePicture(const sw::Image& image, const Options& options) {
    sw::writePng(image, options.output, options.gamma);
    return {};
}

inline void printSummary(const std::string& line, const Options&) {
    print(line + "\n");
}
