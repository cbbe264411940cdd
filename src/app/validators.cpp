#include "app/validators.h"

#include <charconv>

#include "nff/plainText.h"

namespace {

template <typename Number>
std::string refusal(const char* kind, Number least, Number most, const std::string& found) {
    std::ostringstream text = sw::plainStream();
    text << "expected a " << kind << " from " << least << " to " << most << ", found "
         << (found.empty() ? "nothing" : found);
    return text.str();
}

}  // namespace

CLI::Validator wholeNumber(std::uint64_t least, std::uint64_t most) {
    const auto check = [=](std::string& text) {
        std::uint64_t value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size() || value < least ||
            value > most)
            return refusal("whole number", least, most, text);
        text = std::to_string(value);  // CLI11 would read 010 as 8
        return std::string();
    };
    return {check, ""};
}

CLI::Validator number(double least, double most) {
    const auto check = [=](const std::string& text) {
        std::istringstream in(text);
        in.imbue(std::locale::classic());
        double value = 0;
        const bool whole = in >> value && in.peek() == EOF;
        return whole && value >= least && value <= most ? "" : refusal("number", least, most, text);
    };
    return {check, ""};
}

CLI::Validator fileName() {
    const auto check = [](const std::string& text) {
        return text.empty() ? "expected the name of a file, found nothing (a variable not set?)"
                            : "";
    };
    return {check, ""};
}

std::string inPlainWords(const CLI::ParseError& error) {
    const std::string text = error.what();
    if (error.get_name() != "ArgumentMismatch") return text;
    const bool none = text.find("missing") != std::string::npos;
    return text.substr(0, text.find(':')) + ": expected one value, found " +
           (none ? "none" : "several");
}
