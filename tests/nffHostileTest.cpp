#include "files.h"
#include "support.h"
#include "swNff.h"

using namespace sw;
using namespace test;

namespace {

const std::string labScene = contentOf(fs::path(SW_SCENES) / "cornell.nff");

// Whether the text is read, or refused with a position and one line. Anything else is a bug.
bool isHandled(const std::string& text) {
    try {
        const NffScene file = parseNff(text, "a.nff");
        Intersection hit;
        file.scene.intersect(file.camera.getRay(0.5f, 0.5f), hit);
        return file.width >= 1 && file.height >= 1;
    } catch (const NffError& error) {
        const std::string message = error.what();
        int line = 0, column = 0, length = 0;
        return std::sscanf(message.c_str(), "a.nff:%d:%d: expected %n", &line, &column, &length) ==
                   2 &&
               length > 0 && line >= 1 && column >= 1 && message.size() < 200 &&
               message.find(", found ") != std::string::npos &&
               message.find('\n') == std::string::npos;
    }
}

// Copies, so that a sanitizer sees reads beyond the end.
std::string exactCopy(std::string_view text) {
    std::string copy(text);
    copy.shrink_to_fit();
    return copy;
}

std::string mutated(Random& random) {
    std::string text = labScene;
    const auto somewhere = [&] {
        return static_cast<std::size_t>(random.whole(0, static_cast<int>(text.size()) - 1));
    };
    for (int i = random.whole(1, 6); i > 0; --i) {
        const std::size_t at = somewhere();
        switch (random.whole(0, 3)) {
            case 0:
                text[at] = static_cast<char>(random.whole(-128, 127));
                break;
            case 1:
                text[at] = "0123456789 \n.-+eEvblfsp#"[random.whole(0, 23)];
                break;
            case 2:
                text.erase(at, static_cast<std::size_t>(random.whole(1, 20)));
                break;
            default:
                text.insert(at, labScene.substr(somewhere() % labScene.size(), 20));
        }
        if (text.empty()) text.push_back('#');
    }
    return text;
}

}  // namespace

TEST_CASE("a scene cut off anywhere is read or refused") {
    int violations = 0;
    std::size_t first = 0;
    for (std::size_t size = 0; size <= labScene.size(); ++size)
        if (!isHandled(exactCopy(labScene.substr(0, size))) && violations++ == 0) first = size;
    INFO("first after " << first << " bytes");
    CHECK(violations == 0);
}

TEST_CASE("a scene without its beginning is read or refused") {
    int violations = 0;
    std::size_t first = 0;
    for (std::size_t start = 0; start <= labScene.size(); ++start)
        if (!isHandled(exactCopy(labScene.substr(start))) && violations++ == 0) first = start;
    INFO("first without " << first << " bytes");
    CHECK(violations == 0);
}

TEST_CASE("a scene with random faults is read or refused") {
    int violations = 0;
    unsigned first = 0;
    for (unsigned seed = 0; seed < 5000; ++seed) {
        Random random(seed);
        if (!isHandled(exactCopy(mutated(random))) && violations++ == 0) first = seed;
    }
    INFO("first with seed " << first);
    CHECK(violations == 0);
}

TEST_CASE("bytes that are no text are refused") {
    Random random(GENERATE(range(0u, 300u)));
    std::string bytes(static_cast<std::size_t>(random.whole(0, 200)), '\0');
    for (char& byte : bytes) byte = static_cast<char>(random.whole(-128, 127));
    CHECK(isHandled(bytes));
    CHECK(isHandled("\xef\xbb\xbf" + bytes));
}

TEST_CASE("absurdly long tokens and lines are handled") {
    const std::string view = "v from 0 0 5 at 0 0 0 up 0 1 0 angle 45 hither 1 resolution 8 8\n";
    CHECK(isHandled(view + "b 0 0 " + std::string(100000, '0') + "1"));
    CHECK(isHandled(view + "b 0 0 0." + std::string(100000, '3')));
    CHECK(isHandled(view + std::string(1000000, 'x')));
    CHECK(isHandled(view + std::string(1000000, ' ')));
    CHECK(isHandled(view + "#" + std::string(1000000, 'x')));
    CHECK(isHandled(view + "f 1 1 1 1 0 0 0 1 p 1000000 0 0 0"));
    CHECK(isHandled(view + "f 1e38 1 1 1e38 0.9999 0 0 1 s 1e38 -1e38 1e38 3e38"));
    CHECK(
        isHandled("v from -3e38 3e38 3e38 at 3e38 -3e38 3e38 up 3e38 3e38 3e38 angle 179.999 "
                  "hither 1e38 resolution 16384 16384"));
    CHECK(isHandled("v from 0 0 1e-40 at 0 0 0 up 0 1e-40 0 angle 1e-40 hither 0 resolution 1 1"));
}
