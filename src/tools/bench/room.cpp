#include "tools/bench/room.h"

#include "app/scenePath.h"
#include "swNff.h"

namespace bench {

Room loadRoom() {
    std::vector<sw::NffShape> shapes;
    const sw::NffScene file = sw::loadNff(findShippedScene("cornell.nff", ""), &shapes);
    Room room{{}, {}, file.scene.lights().at(0).position};
    for (const sw::NffShape& shape : shapes) {
        const sw::Primitive* primitive = shape.primitive.get();
        if (const auto* sphere = dynamic_cast<const sw::Sphere*>(primitive))
            room.spheres.push_back(*sphere);
        if (const auto* triangle = dynamic_cast<const sw::Triangle*>(primitive))
            room.triangles.push_back(*triangle);
    }
    return room;
}

}  // namespace bench
