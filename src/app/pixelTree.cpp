#include "app/pixelTree.h"

#include "nff/plainText.h"
#include "rayTree/rayTreeText.h"
#include "swImage.h"

std::string describePixel(const Options& options, const sw::NffScene& file,
                          std::vector<sw::NffShape> shapes, const rayTree::Trace& trace) {
    const float x = static_cast<float>(options.pixel->x) + 0.5f;
    const float y = static_cast<float>(options.pixel->y) + 0.5f;
    const rayTree::RayTree tree =
        rayTree::growTree(trace, file.camera.getRay(x, y), file.scene, options.depth);

    std::ostringstream text = sw::plainStream();
    text << "pixel " << options.pixel->x << ',' << options.pixel->y << " of " << options.width
         << 'x' << options.height << ", through its centre";
    if (const auto& color = tree.primary.color) {
        text << ": shown as";
        for (const float channel : color->m)
            text << ' ' << static_cast<int>(sw::toByte(channel, options.gamma));
    }
    text << "\n\n" << describe(tree, file.scene, rayTree::ShapeNames(std::move(shapes)));
    return text.str();
}
