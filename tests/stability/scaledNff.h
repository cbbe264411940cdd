#pragma once

#include <fstream>
#include <locale>
#include <sstream>
#include <string>

namespace test {

/// The text of an NFF file with all of its lengths multiplied by a factor. Understands what our own
/// scenes contain: one statement per line, but 'p' with the vertices on lines of their own.
inline std::string scaledNff(const std::string& path, float factor) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(9);
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line.substr(0, line.find('#')));
        words.imbue(std::locale::classic());
        std::string keyword;
        // How many numbers after the keyword are lengths; a line without one holds vertices.
        int lengths = 1 << 20;
        if (!(words >> std::ws) || words.eof()) continue;
        if (std::isalpha(static_cast<unsigned char>(words.peek())) != 0) {
            words >> keyword;
            out << keyword << ' ';
            const bool point = keyword == "l" || keyword == "from" || keyword == "at";
            lengths = keyword == "s" ? 4 : point ? 3 : keyword == "hither" ? 1 : 0;
        }
        for (float number; words >> number; --lengths)
            out << (lengths > 0 ? number * factor : number) << ' ';
        out << '\n';
    }
    return out.str();
}

}  // namespace test
