// Writes a record of every test case of the lab: as `unfinished` when it starts, so that a crash
// leaves that verdict, and as passed or failed at its end.

#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include <chrono>
#include <exception>
#include <iostream>

#include "catch.h"
#include "lab/record.h"
#include "lab/report/makePage.h"
#include "lab/suddenEnd.h"

namespace {

using lab::Record;

// Where the two versions of Catch2 differ.
#if __has_include(<catch2/catch_all.hpp>)
using ListenerBase = Catch::EventListenerBase;
using AssertionAnswer = void;

template <typename Action>
void forAllTestCases(const Action& action) {
    for (const auto* info : Catch::getRegistryHub().getTestCaseRegistry().getAllInfos())
        action(*info);
}
#else
using ListenerBase = Catch::TestEventListenerBase;
using AssertionAnswer = bool;  // of no meaning to a listener

template <typename Action>
void forAllTestCases(const Action& action) {
    for (const Catch::TestCaseInfo& info :
         Catch::getRegistryHub().getTestCaseRegistry().getAllTests())
        action(info);
}
#endif

// The N of the tag [labN]; 0 without one.
int taskOf(const Catch::TestCaseInfo& info) {
    const std::string tags = info.tagsAsString();
    for (char digit = '1'; digit <= '6'; ++digit)
        if (tags.find(std::string("[lab") + digit + "]") != std::string::npos) return digit - '0';
    return 0;
}

// A report that cannot be written is no reason to fail a test.
template <typename Action>
void whateverHappens(const Action& action) {
    try {
        action();
    } catch (const std::exception& error) {
        std::cerr << "lab report: " << error.what() << std::endl;
    } catch (...) {
        std::cerr << "lab report: something went wrong" << std::endl;
    }
}

// What Catch2 says of a check, in a few lines.
std::string described(const Catch::AssertionStats& stats) {
    const Catch::AssertionResult& result = stats.assertionResult;
    const std::string message(result.getMessage());
    if (result.getResultType() == Catch::ResultWas::ThrewException)
        return "an exception that nobody expected: " + message;
    std::string text;
    const auto add = [&](const std::string& line) {
        if (!line.empty()) text += (text.empty() ? "" : "\n") + line;
    };
    if (result.hasExpandedExpression()) add(std::string(result.getExpandedExpression()));
    add(message);
    for (const Catch::MessageInfo& info : stats.infoMessages)
        if (info.message != message) add(info.message);
    return text;
}

// A check that did not go through lab::fail() has no lesson.
void noteWithoutLesson(const Catch::AssertionStats& stats) {
    Record& record = lab::running();
    if (!(record.tried + record.got + record.expected + record.hint).empty()) return;
    if (stats.assertionResult.hasExpression())
        record.tried = stats.assertionResult.getExpressionInMacro();
    record.got = described(stats);
}

class RecordListener : public ListenerBase {
public:
    using ListenerBase::ListenerBase;

    void testRunStarting(const Catch::TestRunInfo& info) override {
        ListenerBase::testRunStarting(info);
        lab::beforeSuddenEnd = makeReport;
        whateverHappens([] {
            std::vector<lab::Test> tests;
            forAllTestCases([&](const Catch::TestCaseInfo& test) {
                if (taskOf(test) > 0) tests.push_back({taskOf(test), test.name});
            });
            lab::writeTests(tests, SW_LAB_RECORDS);
        });
    }

    void testCaseStarting(const Catch::TestCaseInfo& info) override {
        ListenerBase::testCaseStarting(info);
        whateverHappens([&] {
            lab::running() = Record();
            lab::running().task = taskOf(info);
            lab::running().test = info.name;
            crashed = false;
            started = Clock::now();
            write();
            if (lab::running().task > 0)
                lab::expectSuddenEnd(lab::endFile(lab::running(), SW_LAB_RECORDS), patience());
        });
    }

    AssertionAnswer assertionEnded(const Catch::AssertionStats& stats) override {
        whateverHappens([&] {
            const Catch::AssertionResult& result = stats.assertionResult;
            const bool signal = result.getResultType() == Catch::ResultWas::FatalErrorCondition;
            if (signal && !crashed) lab::noteSignal(std::string(result.getMessage()).c_str());
            crashed |= signal;
            if (!result.isOk() && !crashed) noteWithoutLesson(stats);
        });
        return AssertionAnswer();
    }

    // After a crash it is called as well, from a signal handler: not the place to write files.
    void testCaseEnded(const Catch::TestCaseStats& stats) override {
        whateverHappens([&] {
            if (crashed) return;
            lab::expectNoSuddenEnd();
            lab::running().seconds = std::chrono::duration<double>(Clock::now() - started).count();
            const bool passed = stats.totals.assertions.allOk();
            lab::running().verdict = passed ? Record::Verdict::passed : Record::Verdict::failed;
            write();
        });
        ListenerBase::testCaseEnded(stats);
    }

    void testRunEnded(const Catch::TestRunStats& stats) override {
        ListenerBase::testRunEnded(stats);
        if (!crashed) makeReport();
    }

private:
    // Where two tests of a task took too long already, the others are not worth waiting for.
    static double patience() {
        int tooLong = 0;
        for (const Record& record : lab::readAll(SW_LAB_RECORDS))
            tooLong += record.task == lab::running().task && record.end == "time";
        return tooLong < 2 ? 10 : 1;
    }

    static void makeReport() {
        whateverHappens([] { lab::makePage(SW_LAB_RECORDS, SW_LAB_TESTS, SW_LAB_PAGE); });
    }

    static void write() {
        if (lab::running().task > 0) lab::write(lab::running(), SW_LAB_RECORDS);
    }

    using Clock = std::chrono::steady_clock;
    Clock::time_point started;
    bool crashed = false;
};

}  // namespace

CATCH_REGISTER_LISTENER(RecordListener)
