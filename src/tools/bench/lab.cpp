#include "app/scenePath.h"
#include "tools/bench/drawing.h"
#include "tools/bench/parts.h"

namespace bench {
namespace {

const char* const picture = "lab picture";

}  // namespace

void compareLab(const Setup& setup, Lines& lines) {
    const int size = setup.quick ? 64 : 512;
    const sw::NffScene room = sw::loadNff(findShippedScene("cornell.nff", ""));
    Drawing ours(ourPicture(room, size, labSamples, labDepth), size);
    Drawing original(originalsPicture(size), size);
    const auto embreesWay = embreesPicture(size);
    Drawing embree(embreesWay, size);

    std::vector<std::function<double()>> alone{[&] { return ours.drawAlone(); },
                                               [&] { return original.drawAlone(); }};
    if (embreesWay) alone.push_back([&] { return embree.drawAlone(); });
    const Times one(setup.repetitions(5), alone);
    requireSamePicture(ours.image, original.image, "the original's way");
    if (embreesWay) requireSamePicture(ours.image, embree.image, "Embree");

    // Threads start only now: copying a shared_ptr is cheaper without them.
    const Times two(setup.repetitions(5),
                    {[&] { return ours.draw(2); }, [&] { return ours.draw(1); },
                     [&] { return original.draw(1); }, [&] { return original.draw(2); }});
    const auto line = [&](const std::string& what, const std::string& other, const Times& times,
                          std::size_t i, std::size_t k, std::optional<Target> target) {
        lines.push_back({std::string(picture) + ", " + what, other, "s", times.of(i), times.of(k),
                         times.ratio(k, i), target});
    };
    line("1 thread", "the original's way, 1 thread", one, 0, 1, Target{Target::atLeast, 3});
    line("2 threads", "the original's way, 1 thread", two, 0, 2, Target{Target::atLeast, 5.7});
    line("2 threads", "the original's way, 2 threads", two, 0, 3, std::nullopt);
    if (embreesWay)
        line("1 thread", "Whitted on Embree, 1 thread", one, 0, 2, Target{Target::atLeast, 1.2});
    line("2 threads", "ours, 1 thread", two, 0, 1, Target{Target::atLeast, 1.9});
}

}  // namespace bench
