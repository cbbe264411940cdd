#pragma once

#include <chrono>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "catch.h"
#include "files.h"
#include "lab/record.h"
#include "lab/report/reportProgram.h"

namespace test {

using lab::Record;
using Verdict = Record::Verdict;

inline Record recordOf(int task, const std::string& name, Verdict verdict) {
    Record record;
    record.task = task;
    record.test = name;
    record.verdict = verdict;
    return record;
}

inline bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Bytes of any kind, many of them those that mean something to one of the formats.
inline std::string anyText(unsigned seed) {
    std::mt19937 random(seed);
    constexpr std::string_view special("\n\r\t\\\"<>&'; nend\0\x7f\xc3\xa9\xff", 20);
    std::string text;
    for (auto length = random() % 40; length > 0; --length)
        text += random() % 4 == 0 ? static_cast<char>(random() % 256)
                                  : special[random() % special.size()];
    return text;
}

/// What a student's build folder holds: the records, and the program that makes them.
struct Build {
    Build() { makeFile(program(), ""); }

    fs::path records() const { return folder / "records"; }
    fs::path program() const { return folder / "lab_tests"; }

    /// Notes a test and what came of it.
    void add(const Record& record) {
        lab::write(record, records());
        addUnrun(record.task, record.test);
    }
    void addUnrun(int task, const std::string& name) {
        tests.push_back({task, name});
        lab::writeTests(tests, records());
    }
    void buildAgain() const {
        const auto later = fs::file_time_type::clock::now() + std::chrono::hours(1);
        fs::last_write_time(program(), later);
    }

    std::string page() const {
        std::ostringstream out, err;
        CHECK(lab::reportProgram({"page", records().string(), program().string(),
                                  (folder / "index.html").string()},
                                 out, err) == 0);
        CHECK(out.str() + err.str() == "");
        return contentOf(folder / "index.html");
    }
    std::string grade(const std::string& points = "10,10,10,10,10,10") const {
        std::ostringstream out, err;
        CHECK(lab::reportProgram({"grade", records().string(), program().string(),
                                  (folder / "grade.json").string(), points},
                                 out, err) == 0);
        CHECK(err.str() == "");
        CHECK(out.str() == contentOf(folder / "grade.json"));
        return out.str();
    }

    TemporaryFolder folder;
    std::vector<lab::Test> tests;
};

}  // namespace test
