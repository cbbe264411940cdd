#include <chrono>

#include "lab/report/labBuild.h"

using namespace test;

TEST_CASE("a record survives any text", "[lab]") {
    const auto seed = GENERATE(range(0u, 200u));
    CAPTURE(seed);
    const TemporaryFolder folder;
    Record record = recordOf(static_cast<int>(seed % 6) + 1, anyText(seed), Verdict::failed);
    record.tried = anyText(seed + 1000);
    record.got = anyText(seed + 2000);
    record.expected = anyText(seed + 3000);
    record.hint = anyText(seed + 4000);
    record.pictures = {{anyText(seed + 5000), anyText(seed + 6000), "g", "d", 1, -2, 3}, {}};
    lab::write(record, folder.path);
    const auto all = lab::readAll(folder.path);
    REQUIRE(all.size() == 1);
    const Record& read = all[0];
    CHECK(read.task == record.task);
    CHECK(read.test == record.test);
    CHECK(read.verdict == Verdict::failed);
    CHECK(read.tried == record.tried);
    CHECK(read.got == record.got);
    CHECK(read.expected == record.expected);
    CHECK(read.hint == record.hint);
    REQUIRE(read.pictures.size() == 2);
    CHECK(read.pictures[0].name == record.pictures[0].name);
    CHECK(read.pictures[0].expected == record.pictures[0].expected);
    CHECK(read.pictures[0].got == "g");
    CHECK(read.pictures[0].difference == "d");
    CHECK(read.pictures[0].x == 1);
    CHECK(read.pictures[0].y == -2);
    CHECK(read.pictures[0].steps == 3);
    CHECK(read.pictures[1].name == "");

    const std::vector<lab::Test> tests = {{2, record.test}, {6, record.hint}};
    lab::writeTests(tests, folder.path);
    CHECK(lab::readTests(folder.path) == tests);
}

TEST_CASE("a newer record takes the place of the same test's", "[lab]") {
    const TemporaryFolder folder;
    lab::write(recordOf(2, "b", Verdict::unfinished), folder.path);
    lab::write(recordOf(2, "b", Verdict::passed), folder.path);
    lab::write(recordOf(2, "a", Verdict::failed), folder.path);
    lab::write(recordOf(1, "c", Verdict::unfinished), folder.path);
    const auto all = lab::readAll(folder.path);
    REQUIRE(all.size() == 3);
    CHECK(all[0].test == "c");
    CHECK(all[0].verdict == Verdict::unfinished);
    CHECK(all[1].test == "a");
    CHECK(all[1].verdict == Verdict::failed);
    CHECK(all[2].test == "b");
    CHECK(all[2].verdict == Verdict::passed);
}

TEST_CASE("a record that is cut off or no record is passed over", "[lab]") {
    const TemporaryFolder folder;
    lab::write(recordOf(1, "whole", Verdict::passed), folder.path);
    const std::string whole = contentOf(fs::directory_iterator(folder.path)->path());
    REQUIRE(whole.size() > 20);
    for (std::size_t size = 0; size < whole.size(); ++size)
        makeFile(folder / (std::to_string(size) + ".record"), whole.substr(0, size));
    makeFile(folder / "other.record", "not a record\nend \n");
    fs::create_directory(folder / "folder.record");
    CHECK(lab::readAll(folder.path).size() == 1);
    CHECK(lab::readAll(folder / "no-such-folder").empty());
}

TEST_CASE("a list of tests that says so already is left alone", "[lab]") {
    const TemporaryFolder folder;
    lab::writeTests({{1, "a"}}, folder.path);
    const auto file = fs::directory_iterator(folder.path)->path();
    const auto old = fs::file_time_type::clock::now() - std::chrono::hours(1);
    fs::last_write_time(file, old);
    const auto before = fs::last_write_time(file);
    lab::writeTests({{1, "a"}}, folder.path);
    const auto unchanged = [&] { return fs::last_write_time(file) == before; };
    CHECK(unchanged());
    lab::writeTests({{1, "b"}}, folder.path);
    CHECK_FALSE(unchanged());
}
