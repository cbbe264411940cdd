#include "table.h"

#include <algorithm>
#include <iomanip>
#include <locale>

namespace report {

std::ostringstream plainStream() {
    std::ostringstream stream;
    stream.imbue(std::locale::classic());
    return stream;
}

std::string table(const std::vector<Row>& rows, std::size_t wordColumns) {
    auto text = plainStream();
    const auto line = [&](const Row& row, char fill) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            std::size_t width = 0;
            for (const Row& other : rows) width = std::max(width, other[i].size());
            const bool words = i < wordColumns;
            text << "| " << (words ? std::left : std::right) << std::setfill(fill)
                 << std::setw(static_cast<int>(width)) << row[i]
                 << (fill == '-' && !words ? ":" : " ");
        }
        text << "|\n";
    };
    line(rows[0], ' ');
    line(Row(rows[0].size()), '-');
    for (std::size_t i = 1; i < rows.size(); ++i) line(rows[i], ' ');
    return text.str();
}

}  // namespace report
