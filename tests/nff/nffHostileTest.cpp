#include "files.h"
#include "handled.h"
#include "support.h"

using namespace test;

namespace {

// The lab's scene, and a shape of every other kind: a concave and a crossing polygon among them.
const std::string labScene = contentOf(fs::path(SW_SCENES) / "cornell.nff") +
                             "c 0 0 0 1 0 1 0 0.5\nc 1 1 1 -2 2 2 2 -2\ns 1 2 3 -4\n"
                             "p 4 0 0 0 4 0 0 1 1 0 0 4 0\np 4 0 0 0 4 4 0 4 0 0 0 4 0\n"
                             "pp 3 0 0 0 0 0 1 1 0 0 0 0 1 1 1 0 0 0 1\n"
                             "pp 4 0 0 0 0 0 1 9 0 0 1 0 1 2 2 0 0 0 1 0 9 0 0 1 1\n";

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
                text[at] = "0123456789 \n.-+eEvblfspc#"[random.whole(0, 24)];
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
    CHECK(isHandled(view + "f 1 1 1 1 0 0 0 1 p 10000 0 0 0"));
    CHECK(isHandled(view + "f 1e38 1 1 1e38 0.9999 0 0 1 s 1e38 -1e38 1e38 3e38"));
    CHECK(
        isHandled("v from -3e38 3e38 3e38 at 3e38 -3e38 3e38 up 3e38 3e38 3e38 angle 179.999 "
                  "hither 1e38 resolution 16384 16384"));
    CHECK(isHandled("v from 0 0 1e-40 at 0 0 0 up 0 1e-40 0 angle 1e-40 hither 0 resolution 1 1"));
}
