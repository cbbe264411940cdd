#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "files.h"
#include "support.h"
#include "swImage.h"

namespace test {

/// Random command lines: right and wrong options, values and names of files, in any order.
class CommandLines {
public:
    explicit CommandLines(std::uint64_t seed) : random(seed) {}

    std::vector<std::string> next() {
        words.clear();
        const bool hasScene = random.whole(0, 9) < 7;
        if (hasScene) add(pick(scenes));
        if (random.whole(0, 9) < 7) addOption("-o", files());
        // Without a scene, the lab's: 512 x 512 pixels are too many here.
        if (!hasScene || random.coin()) addOption("--size", pick(sizes));
        for (int i = random.whole(0, 3); i > 0; --i) addAny();
        if (random.whole(0, 3) == 0) add("--quiet");
        if (random.whole(0, 5) == 0) add("--force");
        if (random.whole(0, 9) == 0) add(pick(garbage));
        if (random.whole(0, 9) == 0) std::swap(words.front(), words[anyBelow(words.size())]);
        return words;
    }

private:
    using Texts = std::vector<std::string>;

    std::size_t anyBelow(std::size_t count) {
        return static_cast<std::size_t>(random.whole(0, static_cast<int>(count) - 1));
    }
    // Every other time one of the first four, which are valid.
    const std::string& pick(const Texts& texts) {
        return texts[anyBelow(random.coin() ? std::min<std::size_t>(texts.size(), 4)
                                            : texts.size())];
    }
    const std::string& files() { return pick(random.whole(0, 2) > 0 ? newFiles : otherFiles); }

    // At the end or the front.
    void add(const std::string& word) {
        words.insert(random.coin() ? words.begin() : words.end(), word);
    }

    // In one word or two.
    void addOption(const std::string& option, const std::string& value) {
        if (random.whole(0, 3) == 0 && option.size() > 2) return add(option + "=" + value);
        const auto place = random.coin() ? words.begin() : words.end();
        words.insert(place, {option, value});
    }

    void addAny() {
        const int kind = random.whole(0, 14);
        if (kind < 3) return addOption(pick({"--stats", "--stats", "--error-image"}), files());
        if (kind < 6)
            return addOption(pick({"--samples", "--depth", "--threads", "--seed"}), pick(wholes));
        if (kind < 8)
            return addOption(pick({"--gamma", "--adaptive", "--target-rmse", "--time-limit"}),
                             pick(reals));
        if (kind < 9) return addOption("--crop", pick(windows));
        if (kind < 10) return addOption("--pixel", pick(points));
        if (kind < 11)
            return addOption("--sampler",
                             pick({"jitter", "grid", "random", "multijitter", "", "x"}));
        if (kind < 12) return add("--corners");
        if (kind < 13) return add(pick({"--help", "--version", "-h"}));
        add(pick(garbage));
    }

    Random random;
    Texts words;

    const std::string longName = std::string(300, 'n') + ".png";
    const Texts scenes{
        "scene.nff", "odd.nff",  "-",           "bad.nff",     "./folder/../scene.nff",
        "link.nff",  "hard.nff", "missing.nff", "picture.png", "folder",
        "empty.png", "",         "/dev/null",   "loop.png",    "a\nb.nff",
        longName};
    const Texts newFiles{"new.png",           "new.pfm",        "new.hdr",      "new.json",
                         "NEW.PNG",           "later.png",      "dangling.png", "folder/new.png",
                         "folder/../new.png", "\xc3\xbc b.png", "new\n\x1b.png"};
    const Texts otherFiles{"-",
                           "/dev/null",
                           "/dev/full",
                           "scene.nff",
                           "link.nff",
                           "hard.nff",
                           "folder/up.png",
                           "picture.png",
                           "./picture.png",
                           "notes.txt",
                           "notes.png",
                           "stats.json",
                           "empty.png",
                           "folder",
                           "folder/",
                           ".",
                           "..",
                           "",
                           "missing/new.png",
                           "notes.txt/new.png",
                           "new",
                           "new.jpg",
                           "/dev/stdout",
                           "/dev/fd/1",
                           "/dev/fd/9",
                           "loop.png",
                           "%s%n.png",
                           longName};
    const Texts sizes{"4x4", "4x4", "4x4",   "1x1",     "7x3",   "0x4", "-4x4",        "4",    "4x",
                      "x",   "",    "4x4x4", "99999x4", "4\nx4", "4X4", "16384x16385", "1e1x4"};
    const Texts wholes{
        "1", "2",   "3",  "4",  "0",  "-1", "1.5", "", "1025", "99999999999999999999",
        "x", "0x2", "03", " 2", "2 ", "\n", "+1"};
    const Texts reals{"0.1", "0.3", "0.2",    "1e-1",  "0",   "-1", "nan",
                      "inf", "",    "1e-400", "1e400", "1,5", "x",  "0x1p-2"};
    const Texts windows{"0,0,2,2",  "1,1,3,3", "0,0,4,4", "2,2,2,2", "0,0,99,99",
                        "-1,0,2,2", "",        "1,2,3",   "a,b,c,d"};
    const Texts points{"0,0", "1,2", "3,3", "4,4", "-1,0", "", "1", "1,2,3", "99999999999,1"};
    const Texts garbage{"--sizes",
                        "-z",
                        "--",
                        "---",
                        "-",
                        "=",
                        "--size",
                        "-o",
                        "--quiet=2",
                        "--help=x",
                        "\xff\xfe",
                        "a b",
                        "--no-such-option=4",
                        "\n",
                        "--stats",
                        "-o=",
                        "-onew.png",
                        "--corners=false",
                        "*"};
};

/// A folder for such a command line: scenes, pictures, notes, links.
inline void furnish(const fs::path& folder) {
    const std::string scene =
        "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 6 5\nl 3 3 5\n"
        "f 1 0.5 0.2 0.8 0.1 0 0 1\ns 0 0 0 1\n";
    makeFile(folder / "scene.nff", scene);
    makeFile(folder / "odd.nff", scene + "c 0 0 0 1 0 0 0 1\n");
    makeFile(folder / "bad.nff", scene + "s 1 2\n");
    makeFile(folder / "notes.txt", "notes\n");
    makeFile(folder / "notes.png", "notes\n");
    makeFile(folder / "stats.json", "{\"old\": 1}\n");
    makeFile(folder / "empty.png", "");
    sw::writePng(sw::Image(2, 2), folder / "picture.png");
    fs::create_directory(folder / "folder");
    makeFile(folder / "folder/notes.txt", "notes\n");
    fs::create_hard_link(folder / "scene.nff", folder / "hard.nff");
    fs::create_symlink("scene.nff", folder / "link.nff");
    fs::create_symlink("../picture.png", folder / "folder/up.png");
    fs::create_symlink("later.png", folder / "dangling.png");
    fs::create_symlink("loop.png", folder / "loop.png");
}

}  // namespace test
