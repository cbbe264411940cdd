#include "tools/common/table.h"

#include <algorithm>
#include <cmath>
#include <iomanip>

#include "nff/plainText.h"
#include "tools/common/html.h"

namespace report {

std::string rounded(double value, int digits) {
    if (std::isnan(value)) return "-";
    auto text = sw::plainStream();
    text << std::setprecision(digits) << value;
    return text.str();
}

std::string fixed(double value, int decimals) {
    if (std::isnan(value)) return "-";
    auto text = sw::plainStream();
    text << std::fixed << std::setprecision(decimals) << value;
    return text.str();
}

std::string table(const std::vector<Row>& rows, std::size_t wordColumns) {
    auto text = sw::plainStream();
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

std::string htmlTable(const std::vector<Row>& rows, std::size_t wordColumns) {
    std::string page = "<div class=\"table\"><table>\n";
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const std::string cell = k == 0 ? "th" : "td";
        page += "<tr>";
        for (std::size_t i = 0; i < rows[k].size(); ++i)
            page += "<" + cell + (i < wordColumns ? ">" : " class=\"number\">") +
                    html::escaped(rows[k][i]) + "</" + cell + ">";
        page += "</tr>\n";
    }
    return page + "</table></div>\n";
}

std::string csv(const std::vector<Row>& rows) {
    std::string text;
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) text += (i > 0 ? "," : "") + row[i];
        text += '\n';
    }
    return text;
}

}  // namespace report
