#include "lab/report/page.h"

#include <cmath>

#include "lab/report/pageHead.h"
#include "lab/report/pagePictures.h"
#include "tools/common/html.h"

namespace lab {
namespace {

using html::escaped;
using State = Outcome::State;

// What is known about a test that did not come to its end.
std::string endOf(const Record& record) {
    const std::string during =
        record.endFunction.empty() ? "" : " while " + record.endFunction + " was running";
    if (record.end == "recursion")
        return "The stack is full" + during +
               ": a function calls itself without end. Which condition stops it?";
    if (record.end == "time")
        return "This test was stopped as it took too long" + during +
               ": a loop without end, or code that is far too slow.";
    if (record.end == "exit") return "The program called exit()" + during + ".";
    if (record.end == "signal")
        return "The program crashed" + during + ": " + record.endDetail +
               ". Does an index or a pointer lead to nowhere?";
    return "This test did not come to its end, and nothing is known about why.";
}

std::string element(const std::string& name, const std::string& cssClass, const std::string& html) {
    return "<" + name + (cssClass.empty() ? ">" : " class=\"" + cssClass + "\">") + html + "</" +
           name + ">\n";
}

std::string tests(int number) {
    return std::to_string(number) + (number == 1 ? " test" : " tests");
}

int failures(const Task& task) {
    return task.count(State::failed) + task.count(State::crashed);
}

bool allPassed(const Task& task) {
    return task.size() > 0 && task.count(State::passed) == task.size();
}

// In a few words, with a sign for those who cannot tell the colours apart.
std::string verdict(const Task& task) {
    const int open = task.count(State::notRun);
    if (open == task.size()) return element("span", "quiet", "&#9675; not run yet");
    const bool failed = failures(task) > 0;
    const int count = failed ? failures(task) : task.count(State::passed);
    std::string text = (failed ? "&#10007; failed " : "&#10003; passed ") + std::to_string(count) +
                       " of " + tests(task.size());
    if (open > 0) text += ", " + std::to_string(open) + " not run";
    if (task.outOfDate()) return element("span", "quiet", text + " (out of date)");
    return element("span", failed ? "failed" : open > 0 ? "quiet" : "passed", text);
}

std::string anchor(const Task& task) {
    return "task" + std::to_string(task.number);
}

std::string heading(const Task& task) {
    return "Task " + std::to_string(task.number) + ": " + escaped(task.title);
}

std::string overview(const std::vector<Task>& tasks) {
    int done = 0;
    std::string items;
    for (const Task& task : tasks) {
        if (allPassed(task) && !task.outOfDate()) ++done;
        items += element(
            "li", "",
            "<a href=\"#" + anchor(task) + "\">" + heading(task) + "</a><br>" + verdict(task));
    }
    const std::string all = std::to_string(tasks.size());
    const std::string count = done == static_cast<int>(tasks.size())
                                  ? "All " + all + " tasks pass. Well done!"
                                  : std::to_string(done) + " of " + all + " tasks pass.";
    return element("p", "", count) + element("ul", "tasks", items);
}

std::string definition(const std::string& term, const std::string& text) {
    return text.empty() ? "" : element("dt", "", term) + element("dd", "", escaped(text));
}

std::string staleness(const Outcome& outcome) {
    return outcome.outOfDate
               ? element("p", "quiet", "Out of date: you have built the tests again since.")
               : "";
}

std::string failedTest(const Outcome& outcome, const std::filesystem::path& records) {
    const Record& record = outcome.record;
    const bool crashed = outcome.state == State::crashed;
    const std::string facts = definition("Tried", record.tried) + definition("Got", record.got) +
                              definition("Expected", record.expected) +
                              definition("What happened", crashed ? endOf(record) : "");
    const std::string& hint = record.hint;
    return element(
        "div", "test",
        "<h3><span class=\"failed\">&#10007;</span> " + escaped(record.test) + "</h3>\n" +
            staleness(outcome) + (facts.empty() ? "" : element("dl", "", facts)) +
            (hint.empty() ? "" : element("p", "hint", "<strong>Hint:</strong> " + escaped(hint))) +
            picturesOf(record, records));
}

std::string folded(const std::string& summary, const std::string& html) {
    return html.empty() ? ""
                        : "<details><summary>" + summary + "</summary>\n" + html + "</details>\n";
}

bool isFailed(const Outcome& outcome) {
    return outcome.state == State::failed || outcome.state == State::crashed;
}

// What a test says beside its facts: the hint, or how it ended, or the exception that was thrown.
std::string verdictOf(const Outcome& outcome) {
    const Record& record = outcome.record;
    if (outcome.state == State::crashed) return endOf(record);
    return record.hint.empty() && record.expected.empty() ? record.got : record.hint;
}

// Whether an earlier test says the same. A test with pictures has more to say than that.
bool onlyRepeats(const Outcome& outcome, const Outcome& earlier) {
    return isFailed(outcome) && outcome.record.pictures.empty() && !verdictOf(outcome).empty() &&
           verdictOf(outcome) == verdictOf(earlier);
}

// The first test with each verdict in full, and those that would repeat it folded behind it.
std::string failedTests(const Task& task, const std::filesystem::path& records) {
    std::string html;
    std::vector<bool> done(task.outcomes.size());
    for (std::size_t i = 0; i < done.size(); ++i) {
        if (done[i] || !isFailed(task.outcomes[i])) continue;
        html += failedTest(task.outcomes[i], records);
        std::string others;
        int count = 0;
        for (std::size_t k = i + 1; k < done.size(); ++k) {
            if (done[k] || !onlyRepeats(task.outcomes[k], task.outcomes[i])) continue;
            done[k] = true;
            others += failedTest(task.outcomes[k], records);
            ++count;
        }
        html += folded(
            std::to_string(count) + (count == 1 ? " more test" : " more tests") + ": the same",
            others);
    }
    return html;
}

// No test takes a right solution a second. It costs no points, but is worth a word.
std::string slowTests(const Task& task) {
    constexpr double slow = 2;
    std::string items;
    for (const Outcome& outcome : task.outcomes)
        if (outcome.record.seconds > slow)
            items += element("li", "",
                             escaped(outcome.record.test) + ": " +
                                 std::to_string(std::lround(outcome.record.seconds)) + " s");
    return items.empty()
               ? ""
               : element("p", "note", "These tests took long. Is some work done again and again?") +
                     element("ul", "", items);
}

std::string note(const Record& record) {
    return record.got.empty() ? "" : ": " + record.got;
}

// The names of the tests that came out so, to be unfolded. One that passed may have a note.
std::string namesOf(const Task& task, State state, const std::string& what) {
    std::string items;
    for (const Outcome& outcome : task.outcomes)
        if (outcome.state == state)
            items += element("li", "",
                             escaped(outcome.record.test + note(outcome.record)) +
                                 (outcome.outOfDate ? " (out of date)" : ""));
    return items.empty() ? ""
                         : folded(tests(task.count(state)) + " " + what, element("ul", "", items));
}

std::string section(const Task& task, const std::filesystem::path& records) {
    std::string html = "<section id=\"" + anchor(task) + "\">\n" +
                       element("h2", "", heading(task)) + element("p", "verdict", verdict(task));
    const std::string command =
        "<code>cmake --workflow --preset lab" + std::to_string(task.number) + "</code>";
    if (task.outOfDate())
        html += element("p", "note",
                        "You have built the tests again since this run. For what your code does "
                        "now, run " +
                            command + " again.");
    else if (task.count(State::notRun) > 0)
        html += element("p", "quiet", "To run these tests: " + command);
    html += failedTests(task, records);
    for (const Outcome& outcome : task.outcomes)
        if (outcome.state == State::passed) html += picturesOf(outcome.record, records);
    html += slowTests(task);
    return html + namesOf(task, State::passed, "passed") +
           namesOf(task, State::notRun, "not run yet") + "</section>\n";
}

}  // namespace

std::string page(const std::vector<Task>& tasks, const std::filesystem::path& records,
                 const std::string& when) {
    std::string html = pageHead;
    html += element("p", "quiet",
                    when.empty() ? "No test has run yet. Write some code, then run <code>cmake "
                                   "--workflow --preset test</code>."
                                 : "Last test run: " + escaped(when));
    html += overview(tasks);
    for (const Task& task : tasks) html += section(task, records);
    return html + "</body></html>\n";
}

}  // namespace lab
