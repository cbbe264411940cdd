#include "app/programRun.h"
#include "catch.h"
#include "tools/common/scenes/scenes.h"

using namespace test;

TEST_CASE("the program writes the scene to standard output or to a file") {
    const TemporaryFolder folder;
    const Run printed = runProgram(SW_GENERATOR, folder, "tetra --size 2");
    CHECK((printed.code == 0 && printed.err.empty()));
    CHECK(printed.out == scenes::tetra(2));
    CHECK(runProgram(SW_GENERATOR, folder, "balls").out == scenes::balls(4));
    const Run written = runProgram(SW_GENERATOR, folder, "mount --size 3 -o here.nff");
    CHECK((written.code == 0 && written.out.empty() && written.err.empty()));
    CHECK(contentOf(folder / "here.nff") == scenes::mount(3));
    CHECK(folder.count() == 1);
    const Run help = runProgram(SW_GENERATOR, folder, "--help");
    CHECK(help.code == 0);
    for (const auto& scene : scenes::generators)
        CHECK(help.out.find(std::string("\n  ") + scene.name) != std::string::npos);
}

TEST_CASE("the program refuses invalid arguments in one line") {
    const TemporaryFolder folder;
    const std::string arguments = GENERATE(
        "", "gears", "balls --size 7", "balls --size -1", "tetra --size 0", "tetra --size 11",
        "mount --size 0", "mount --size 11", "mount --size x", "balls tetra", "--size 3");
    CAPTURE(arguments);
    const Run run = runProgram(SW_GENERATOR, folder, arguments);
    CHECK(run.code == 2);
    CHECK(run.out.empty());
    CHECK(startsWith(run.err, "swtracer-scene: "));
    CHECK(lines(run.err) == 1);
}

TEST_CASE("an output that cannot be written is refused and nothing is left behind") {
    const TemporaryFolder folder;
    const Run run = runProgram(SW_GENERATOR, folder, "--output no/such/folder.nff mount");
    CHECK(run.code == 4);
    CHECK(startsWith(run.err, "swtracer-scene: no/such/folder.nff: cannot write: "));
    CHECK(folder.count() == 0);
}
