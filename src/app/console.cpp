#include "app/console.h"

#include <cctype>
#include <cerrno>
#include <iostream>
#include <system_error>

#include "swFile.h"

std::string oneLine(const std::string& text) {
    std::string line;
    for (const char c : text)
        if (const auto byte = static_cast<unsigned char>(c); byte < 0x80 && std::iscntrl(byte))
            line.append("\\x").append({"01234567"[c >> 4], "0123456789abcdef"[c & 15]});
        else
            line += c;
    return line;
}

void printWarnings(const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings)
        std::cerr << "swtracer: " << oneLine(warning) << std::endl;
}

void print(const std::string& text) {
    errno = 0;
    std::cout << text << std::flush;
    if (!std::cout)
        throw sw::FileError("standard output: cannot write: " +
                            std::generic_category().message(errno ? errno : EIO));
}
