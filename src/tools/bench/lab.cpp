#include <cmath>
#include <stdexcept>

#include "app/scenePath.h"
#include "swNff.h"
#include "swRenderer.h"
#include "tools/bench/parts.h"
#include "tools/bench/picture.h"
#include "tools/common/mainFunctions.h"

namespace bench {
namespace {

// Renders the picture with a function for its pixels.
class Drawing {
public:
    sw::Image image;

    Drawing(Radiance how, int size) : image(size, size), radiance(std::move(how)) {}

    /// Both return the time in seconds: wall time or processor time.
    double draw(int threads) {
        return secondsOf([&] { paint(threads); });
    }
    double drawAlone() {
        return processorSecondsOf([&] { paint(1); });
    }

private:
    void paint(int threads) {
        const sw::Window all{0, 0, image.width(), image.height()};
        image = sw::render(all, radiance, {.threads = threads}).image;
    }

    Radiance radiance;
};

// Mean difference of two pictures' channels.
double difference(const sw::Image& a, const sw::Image& b) {
    double sum = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            for (int i = 0; i < 3; ++i)
                sum += std::fabs(static_cast<double>(a.at(x, y)[i] - b.at(x, y)[i]));
    return sum / (3.0 * a.width() * a.height());
}

// Pictures differ by rounding, and at some shadow edges by the epsilon.
void requireSamePicture(const Drawing& ours, const Drawing& other, const std::string& name) {
    const double d = difference(ours.image, other.image);
    if (!(d < 0.01))
        throw std::runtime_error("the picture of " + name + " differs from ours by " +
                                 std::to_string(d) + " on average; expected less than 0.01");
}

const char* const picture = "lab picture";

}  // namespace

Radiance ourPicture(int size) {
    sw::NffScene file = sw::loadNff(findShippedScene("cornell.nff", ""));
    file.camera.setup(size, size);
    file.scene.prepare();
    return [file](int x, int y) {
        return lab::samplePixel(static_cast<float>(x), static_cast<float>(y), labSamples, labDepth,
                                file.camera, file.scene);
    };
}

void compareLab(const Setup& setup, Lines& lines) {
    const int size = setup.quick ? 64 : 512;
    Drawing ours(ourPicture(size), size), original(originalsPicture(size), size);
    const auto embreesWay = embreesPicture(size);
    Drawing embree(embreesWay, size);

    std::vector<std::function<double()>> alone{[&] { return ours.drawAlone(); },
                                               [&] { return original.drawAlone(); }};
    if (embreesWay) alone.push_back([&] { return embree.drawAlone(); });
    const Times one(setup.repetitions(5), alone);
    requireSamePicture(ours, original, "the original's way");
    if (embreesWay) requireSamePicture(ours, embree, "Embree");

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
        line("1 thread", "Whitted on Embree, 1 thread", one, 0, 2, Target{Target::atLeast, 1.6});
    line("2 threads", "ours, 1 thread", two, 0, 1, Target{Target::atLeast, 1.9});
}

}  // namespace bench
