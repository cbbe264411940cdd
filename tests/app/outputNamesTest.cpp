// What -o, --stats and --error-image may name.
#include "app/programRun.h"
#include "support.h"

using namespace test;

namespace {

const std::string tiny = " --size 4x4 --samples 2 ";
const std::string png = "\x89PNG\r\n\x1a\n";
const fs::path shipped = fs::path(SW_SCENES) / "one-triangle.nff";

// A folder with a scene, a folder, and other names for the scene.
class SceneFolder : public TemporaryFolder {
public:
    SceneFolder() {
        makeFile(*this / "my.nff", contentOf(shipped));
        fs::create_directory(*this / "sub");
        fs::create_hard_link(*this / "my.nff", *this / "hard.png");
        aliases = {"my.nff", "./my.nff", "sub/../my.nff", "hard.png", (*this / "my.nff").string()};
#ifndef _WIN32  // where only administrators make links
        fs::create_symlink("my.nff", *this / "link.png");
        fs::create_symlink("../link.png", *this / "sub/link.json");
        fs::create_directory_symlink("sub/..", *this / "here");
        aliases.insert(aliases.end(), {"link.png", "sub/link.json", "here/my.nff"});
#endif
        // The same name in another case, where the file system does not tell them apart.
        if (fs::exists(*this / "MY.NFF")) aliases.push_back("MY.nff");
    }
    std::vector<std::string> aliases;
};

// Runs the program, which must refuse the command line, naming both, before it does anything.
void checkRefused(const TemporaryFolder& folder, const std::string& arguments,
                  const std::string& one, const std::string& other) {
    const int filesBefore = folder.count();
    const Run run = swtracer(folder, arguments);
    CAPTURE(arguments, run.out, run.err);
    CHECK(run.code == 2);
    CHECK(run.out.empty());
    CHECK(lines(run.err) == 1);
    CHECK(has(run.err, one));
    CHECK(has(run.err, other));
    CHECK(folder.count() == filesBefore);
}

}  // namespace

TEST_CASE("no output may be the scene, whatever it is called") {
    const std::string option =
        GENERATE(as<std::string>(), "-o", "--stats", "--error-image", "--explore");
    const std::string force = GENERATE("", " --force");
    const SceneFolder folder;
    for (const std::string& alias : folder.aliases) {
        checkRefused(folder, "my.nff" + tiny + option + " " + alias + force, "scene", option);
        checkRefused(folder, alias + tiny + option + " my.nff" + force, "scene", option);
    }
    CHECK(contentOf(folder / "my.nff") == contentOf(shipped));
}

TEST_CASE("no two outputs may be one file, whether it exists or not") {
    const auto [one, other] =
        GENERATE(table<std::string, std::string>({{"-o", "--stats"},
                                                  {"-o", "--error-image"},
                                                  {"--stats", "--error-image"},
                                                  {"-o", "--explore"}}));
    const bool exists = GENERATE(false, true);
    const SceneFolder folder;
    if (exists) makeFile(folder / "a.png", png);
    std::vector<std::string> names = {"a.png", "./a.png", "sub/../a.png",
                                      (folder / "a.png").string()};
#ifndef _WIN32  // where only administrators make links
    fs::create_symlink("a.png", folder / "la.png");
    fs::create_symlink("../la.png", folder / "sub/lla.png");
    names.insert(names.end(), {"la.png", "sub/lla.png", "here/a.png"});
#endif
    if (fs::exists(folder / "MY.NFF")) names.push_back("A.PNG");
    for (const std::string& name : names) {
        const std::string tail = one + " " + name + " " + other + " a.png";
        checkRefused(folder, "my.nff" + tiny + tail, one, other);
    }
    checkRefused(folder, "my.nff --stats out.png", "-o", "--stats");  // its default
    CHECK(contentOf(folder / "a.png") == (exists ? png : ""));
}

TEST_CASE("a file of another kind is replaced only by force") {
    const auto [option, name] =
        GENERATE(table<std::string, std::string>({{"-o", "a.png"},
                                                  {"-o", "a.pfm"},
                                                  {"-o", "a.hdr"},
                                                  {"--stats", "a.json"},
                                                  {"--error-image", "a.png"}}));
    const bool json = option == "--stats";
    const TemporaryFolder folder;
    const std::string arguments =
        tiny + (option == "-o" ? "" : "-o b.png ") + option + " " + name + " --quiet";
    CAPTURE(arguments);
    for (const std::string& content :
         {std::string("my notes\n"), contentOf(shipped), std::string(1, '\0'),
          std::string("\x89PN"), std::string("#?RAD"), json ? png + "x" : std::string("{}")}) {
        makeFile(folder / name, content);
        checkRefused(folder, arguments, option, name + " exists and is no ");
        CHECK((contentOf(folder / name) == content));
    }
    CHECK(swtracer(folder, arguments + " --force").code == 0);
    CHECK(contentOf(folder / name) != "{}");
    CHECK(swtracer(folder, arguments).code == 0);  // its own work
    makeFile(folder / name, "");                   // nobody's work
    CHECK(swtracer(folder, arguments).code == 0);
    makeFile(folder / name, json ? " \n{\"a\": 1}" : "PF\n1 1\n-1.0\n0123456789ab");
    CHECK(swtracer(folder, arguments).code == 0);
}

TEST_CASE("a name says which picture it holds or is refused with the right one") {
    const TemporaryFolder folder;
    for (const std::string name : {"a.jpg", "a.ppm", "a", "a.", "a.nff", ".png", "a.png.bak"}) {
        const std::string better = fs::path(name).replace_extension(".png").string();
        checkRefused(folder, tiny + "-o " + name, "-o: expected a name that ends in .png",
                     "found " + name + " (" + better + "?)");
        checkRefused(folder, tiny + "--error-image " + name, "--error-image: expected", name);
    }
    checkRefused(folder, tiny + "--error-image a.pfm", "--error-image", "a.pfm");
    checkRefused(folder, tiny + "-o a.pfm --gamma 1", "--gamma", "a.pfm");
    CHECK(swtracer(folder, tiny + "-o A.PNG").code == 0);
    CHECK(contentOf(folder / "A.PNG").substr(0, 8) == png);
}

TEST_CASE("the summary names a stream as every system does") {
    const TemporaryFolder folder;
    const Run run = swtracer(folder, tiny + "-o -");
    CHECK(run.code == 0);
    CHECK(startsWith(run.out, png));
    CHECK(startsWith(run.err, "/dev/stdout  4x4  "));
}

TEST_CASE("names in any script are those of files") {
    const TemporaryFolder folder;
    const std::string name =
        "gr\xc3\xb6\xc3\x9f"
        "e \xe6\x9b\xb8";  // UTF-8
    const fs::path real = folder.path / fs::path(u8"gr\u00f6\u00dfe \u66f8");
    fs::copy_file(shipped, fs::path(real).concat(".nff"));
    const auto quotedName = [&](const char* ending) { return "\"" + name + ending + "\""; };
    const Run run = swtracer(folder, quotedName(".nff") + tiny + "-o " + quotedName(".png") +
                                         " --stats " + quotedName(".json"));
    CAPTURE(run.out, run.err);
    CHECK(run.code == 0);
    CHECK(has(run.out, name + ".png  4x4  "));
    CHECK(contentOf(fs::path(real).concat(".png")).substr(0, 8) == png);
    CHECK(contentOf(fs::path(real).concat(".json")).substr(0, 2) == "{\n");
    CHECK(folder.count() == 3);
    const Run again = swtracer(folder, "--quiet " + tiny + "-o " + quotedName("/a.png"));
    CHECK(again.code == 4);
    CHECK(has(again.err, name));
}

#ifdef _WIN32
TEST_CASE("the device that takes everything is none of a folder's files") {
    const std::string name = GENERATE("nul", "NUL");
    const TemporaryFolder folder;
    const Run run =
        swtracer(folder, tiny + "-o " + name + " --stats nul --error-image nul --quiet");
    CAPTURE(run.err);
    CHECK(run.code == 0);
    CHECK(folder.count() == 0);
    CHECK(startsWith(swtracer(folder, tiny + "-o " + name).out, name + "  4x4  "));
}
#endif

TEST_CASE("devices take any number of outputs of any kind") {
    if (!fs::exists("/dev/null")) return;
    const TemporaryFolder folder;
    const Run run =
        swtracer(folder, tiny + "-o /dev/null --stats /dev/null --error-image /dev/null --quiet");
    CAPTURE(run.err);
    CHECK(run.code == 0);
    CHECK(fs::is_character_file("/dev/null"));
    CHECK(folder.count() == 0);
}
