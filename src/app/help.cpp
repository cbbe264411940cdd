#include "app/help.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "app/usage.h"

namespace {

constexpr const char* examples = R"(Examples:
  swtracer                                        the lab's scene, to out.png
  swtracer my.nff -o my.png --size 800x600        a scene of one's own
  swtracer my.nff --pixel 130,240                 why is this pixel black?
  swtracer my.nff --explore rays.html             the same for every pixel, to look at

Output FILE: .png, .pfm and .hdr for linear values, or - for standard output. Scene -: from
standard input.

Error: rmse 0.0055 +- 0.0004 (est.) is the picture's root mean square error in linear radiance, and
the standard error of that number. It counts details that the samples may have missed, as far as
independent samples find them; it cannot know of what none has hit.

Exit codes: 0 done, 2 command line or too little memory, 3 scene, 4 output, 128+n ended by signal n,
1 anything else.)";

// How many letters must be put in, left out or replaced to make one text of the other (Levenshtein,
// Binary codes capable of correcting deletions, insertions, and reversals, 1966).
std::size_t editDistance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t(0));
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] != b[j]);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
        }
    }
    return row.back();
}

// Letters alone, so that -size and --Size are near --size.
std::string lettersOf(const std::string& option) {
    std::string letters = option.substr(0, option.find('='));
    std::erase(letters, '-');
    for (char& c : letters) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return letters;
}

// The option's name that is nearest to what was typed; empty if none is near.
std::string nearestTo(const std::string& typed, const CLI::App& app) {
    const std::string letters = lettersOf(typed).substr(0, 100);
    std::string nearest;
    std::size_t least = std::max<std::size_t>(letters.size() / 3, 1) + 1;
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_positional()) continue;
        for (const std::string& name : option->get_lnames()) {
            const std::size_t distance = editDistance(letters, lettersOf(name));
            if (distance < least) nearest = "--" + name;
            least = std::min(least, distance);
        }
        for (const std::string& name : option->get_snames())
            if (letters == name) nearest = "-" + name;
    }
    return nearest;
}

}  // namespace

void arrangeHelp(CLI::App& app) {
    const auto group = [&](const char* name, std::initializer_list<const char*> options) {
        for (const char* option : options) app.get_option(option)->group(name);
    };
    group("Picture", {"--output", "--size", "--crop", "--gamma", "--preview", "--force"});
    group("Rays", {"--samples", "--sampler", "--depth", "--corners", "--seed", "--threads"});
    group("Adaptive sampling", {"--adaptive", "--target-rmse", "--time-limit"});
    group("More to learn", {"--explore", "--pixel", "--stats", "--error-image"});
    group("This program", {"--help", "--version", "--quiet"});
    for (const char* file : {"scene", "--output", "--explore", "--stats", "--error-image"})
        app.get_option(file)->type_name("FILE");
    for (const char* text : {"--size", "--crop", "--pixel", "--sampler"})
        app.get_option(text)->type_name("");
    app.footer(examples);
    app.allow_extras();  // for refuseUnknown() to find
}

void refuseUnknown(const CLI::App& app) {
    const std::vector<std::string> unknown = app.remaining();
    if (unknown.empty()) return;
    const std::string& typed = unknown.front();
    if (typed.empty() || typed[0] != '-')
        throw UsageError("expected one scene, found another one: '" + typed + "'");
    const std::string nearest = nearestTo(typed, app);
    throw UsageError(typed + ": there is no such option" +
                     (nearest.empty() ? "" : "; did you mean " + nearest + "?") +
                     " (--help lists all)");
}
