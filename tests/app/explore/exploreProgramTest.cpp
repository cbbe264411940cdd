// --explore FILE, as the program takes it.
#include "app/programRun.h"
#include "support.h"

using namespace test;

namespace {

const std::string tiny = "--size 16x12 --quiet ";

std::string refused(const TemporaryFolder& folder, const std::string& arguments) {
    const int before = folder.count();
    const Run run = swtracer(folder, tiny + arguments);
    CAPTURE(arguments, run.err);
    CHECK(run.code == 2);
    CHECK(folder.count() == before);
    return run.err;
}

}  // namespace

TEST_CASE("the page is one file beside the same picture") {
    const TemporaryFolder folder;
    const Run run = swtracer(folder, tiny + "--explore rays.html");
    CAPTURE(run.err);
    CHECK(run.code == 0);
    CHECK(folder.count() == 2);
    CHECK(contentOf(folder / "out.png") == picture(tiny));
    const std::string page = contentOf(folder / "rays.html");
    CHECK(page.starts_with("<!doctype html>"));
    CHECK(page.find("\"columns\":16,\"rows\":12,\"rays\":") != std::string::npos);
    for (const char* outside :
         {"http:", "https:", "src=", "@import", "<!-- data -->", "/* page.js */"})
        CHECK(page.find(outside) == std::string::npos);
}

TEST_CASE("the page of a window is that of its pixels") {
    const TemporaryFolder folder;
    CHECK(swtracer(folder, tiny + "--crop 3,2,10,7 --explore -")
              .out.find("\"left\":3,\"top\":2,\"step\":1,\"columns\":7,\"rows\":5") !=
          std::string::npos);
}

TEST_CASE("a hostile scene name is text in the page") {
    const TemporaryFolder folder;
    const std::string name = "x'&quot;-alert(1)-<img src=x onerror=alert(2)>.nff";
    makeFile(folder / name, contentOf(fs::path(SW_SCENES) / "spheres.nff"));
    const Run run = swtracer(folder, quoted(fs::path(name)) + " " + tiny + "--explore rays.html");
    CAPTURE(run.err);
    CHECK(run.code == 0);
    CHECK(contentOf(folder / "rays.html").find("<img") == std::string::npos);
}

TEST_CASE("only pages are replaced, and only by pages") {
    const TemporaryFolder folder;
    makeFile(folder / "work.html", "my notes");
    CHECK(refused(folder, "--explore work.html").find("exists and is no page") !=
          std::string::npos);
    CHECK(refused(folder, "--explore rays.png").find("(rays.html?)") != std::string::npos);
    CHECK(refused(folder, "--explore a.html -o a.html") != "");
    CHECK(swtracer(folder, "--explore a.html --pixel 1,1").err ==
          "swtracer: --pixel: expected no --explore beside it, found both (leave one out)\n");
    CHECK(contentOf(folder / "work.html") == "my notes");
    CHECK(swtracer(folder, tiny + "--explore work.html --force").code == 0);
    CHECK(swtracer(folder, tiny + "--explore work.html").code == 0);
    CHECK(swtracer(folder, tiny + "--explore no/such/folder.html").code == 4);
}
