#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "swFile.h"

namespace test {

namespace fs = std::filesystem;

/// An empty folder of its own, removed with all its content at the end.
class TemporaryFolder {
public:
    TemporaryFolder()
        : path(fs::canonical(fs::temp_directory_path()) /
               ("swtracer-test-" + std::to_string(std::random_device()()) + "-" +
                std::to_string(std::random_device()()))) {
        fs::create_directory(path);
    }
    ~TemporaryFolder() {
        std::error_code none;
        fs::remove_all(path, none);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    fs::path operator/(const std::string& name) const { return path / name; }
    /// How many files and folders it holds.
    int count() const { return static_cast<int>(std::distance(fs::directory_iterator(path), {})); }

    const fs::path path;
};

/// The bytes of a file, without help from the library; empty if there is none.
inline std::string contentOf(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Makes or overwrites a file in place, without help from the library.
inline void makeFile(const fs::path& path, const std::string& content) {
    std::ofstream(path, std::ios::binary) << content;
}

/// What the FileError of an action says, or "" if there is none.
template <typename Action>
std::string errorOf(const Action& action) {
    try {
        action();
    } catch (const sw::FileError& error) {
        return error.what();
    }
    return "";
}

inline bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

inline bool startsWith(const std::string& text, const std::string& start) {
    return text.compare(0, start.size(), start) == 0;
}

}  // namespace test
