#include "catch.h"
#include "tools/bench/povrayScene.h"

namespace {

std::size_t countOf(const std::string& word, const std::string& text) {
    std::size_t count = 0;
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
    return count;
}

std::string written(const std::string& nff) {
    std::vector<sw::NffShape> shapes;
    const sw::NffScene scene = sw::parseNff(
        "v from 0 0 5 at 0 0 0 up 0 1 0 angle 90 resolution 8 4\nb .25 .5 1\nl 1 2 3\n"
        "f 1 .5 0 .75 .25 0 0 1\n" +
            nff,
        "test", &shapes);
    return bench::povrayScene(scene, shapes, 4);
}

bool contains(const std::string& text, const std::string& part) {
    return countOf(part, text) == 1;
}

}  // namespace

TEST_CASE("every shape becomes an object of the same kind") {
    const std::string kinds[] = {"sphere {", "cone {", "cylinder {", "\ntriangle {",
                                 "smooth_triangle {"};
    const std::string statements[] = {"s 0 0 0 1\n", "c 0 0 0 1 0 1 0 .5\n", "c 0 0 0 1 0 1 0 1\n",
                                      "p 3 0 0 0 1 0 0 0 1 0\n",
                                      "pp 3 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1\n"};
    for (std::size_t i = 0; i < 5; ++i) {
        CAPTURE(statements[i]);
        const std::string text = written(statements[i] + statements[i]);
        for (std::size_t k = 0; k < 5; ++k) CHECK(countOf(kinds[k], text) == (i == k ? 2 : 0));
    }
    CHECK(countOf("triangle {", written("p 5 0 0 0 1 0 0 1 1 0 .5 2 0 0 1 0\n")) == 3);
    CHECK(countOf(" open", written("c 0 0 0 1 0 1 0 .5\nc 0 0 0 1 0 1 0 1\n")) == 2);
}

TEST_CASE("a surface scatters what it does not mirror, and nothing shines by itself") {
    const std::string text = written("s 0 0 0 1\n");
    CHECK(contains(text, "rgb <1,0.5,0> transmit 0 "));
    CHECK(contains(text, "ambient 0 specular 0 phong 0 diffuse 0.75 reflection 0.25 "));
    CHECK(contains(text, "background { rgb <0.25,0.5,1> }"));
    CHECK(contains(text, "light_source { <1,2,3> rgb <1,1,1> }"));
    CHECK(contains(text, "max_trace_level 5 "));
}

TEST_CASE("glass throws a black shadow: that of another object, which is not seen") {
    const std::string text = written("f 1 1 1 1 .25 0 .5 1.5\ns 0 0 0 1\n");
    CHECK(contains(text, " transmit 0.5 "));
    CHECK(contains(text, " diffuse 0.5 reflection 0.25 "));  // of the half that goes not through
    CHECK(contains(text, "interior { ior 1.5 } no_shadow }"));
    CHECK(countOf("sphere { <0,0,0>,1 ", text) == 2);
    CHECK(contains(text, "no_image no_reflection }"));
}

TEST_CASE("the picture is square and as high as the scene's") {
    CHECK(contains(written("s 0 0 0 1\n"),
                   "location <0,0,5> direction <0,0,-1> right <2,0,0> up <0,2,0> }"));
}
