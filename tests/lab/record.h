#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// What the lab's tests leave behind for the report and the grade: one small file per test case in
/// the folder SW_LAB_RECORDS.
namespace lab {

/// Files of a picture test; all PNG.
struct PictureRecord {
    std::string name;                       ///< of the picture
    std::string expected, got, difference;  ///< file names in the records' folder
    int x = 0, y = 0;                       ///< where the difference is largest ...
    int steps = 0;                          ///< ... and how large, in steps of 8 bits
};

struct Record {
    enum class Verdict { passed, failed, unfinished };  ///< unfinished: crashed, or still running
    int task = 0;                                       ///< 1..6
    std::string test;                                   ///< the test case's name
    Verdict verdict = Verdict::unfinished;
    std::string tried, got, expected, hint;  ///< of the check that failed; else empty
    /// How an unfinished test ended, where that is known: "signal", "recursion", "exit" or "time";
    /// more about it; and which function of the student's was running. readAll() fills these in.
    std::string end, endDetail, endFunction;
    double seconds = 0;  ///< that the test case took
    std::vector<PictureRecord> pictures;
    std::filesystem::file_time_type when{};  ///< it was written; readAll() fills this in
};

/// Writes a record's file, whole or not at all; overwrites an older one of the same test. Makes the
/// folder if there is none.
/// @throws sw::FileError, std::filesystem::filesystem_error
void write(const Record& record, const std::filesystem::path& folder);

/// The file that says how a record's test ended suddenly, if it did.
std::filesystem::path endFile(const Record& record, const std::filesystem::path& folder);

/// All records of a folder, by task and then by name; files that are none are passed over.
/// Empty if there is no such folder.
std::vector<Record> readAll(const std::filesystem::path& folder);

/// What fail() and expectPicture() note goes into the record of the running test case.
Record& running();

/// A test case that there is, whether it has run or not.
struct Test {
    int task = 0;
    std::string name;

    bool operator==(const Test&) const = default;
};

/// Notes which test cases there are, in their order. Leaves a file that says so already alone.
/// @throws as write()
void writeTests(const std::vector<Test>& tests, const std::filesystem::path& folder);

/// What writeTests() noted; empty if nothing.
std::vector<Test> readTests(const std::filesystem::path& folder);

}  // namespace lab
