#include "app/outputs.h"

#include <iostream>
#include <new>
#include <system_error>

#include "app/console.h"
#include "app/pictureFormat.h"
#include "files/target.h"
#include "swFile.h"

namespace {

namespace fs = std::filesystem;

// out.png, out-1.png, out-2.png: the first name that is free.
fs::path freeName(const fs::path& file, const fs::path& folder) {
    fs::path name;
    std::error_code none;
    for (int i = 1; name.empty() || fs::exists(fs::symlink_status(name, none)); ++i)
        name = folder /
               file.stem().concat("-").concat(std::to_string(i)).concat(file.extension().native());
    return name;
}

// Where the content was written instead; empty if there is no place for it.
fs::path saveElsewhere(const fs::path& file, const std::string& content) {
    std::error_code none;
    for (const fs::path& folder : {file.parent_path(), fs::temp_directory_path(none)}) {
        if (!fs::is_directory(folder, none)) continue;
        try {
            const fs::path name = freeName(file, folder);
            sw::writeFile(name, content);
            return name;
        } catch (const sw::FileError&) {
        }
    }
    return {};
}

}  // namespace

void requireOutputs(const Options& options) {
    const PictureFormat format = formatOf(options.output).value_or(PictureFormat::png);
    sw::requireWritable(options.output,
                        leastSize(format, options.crop->width(), options.crop->height()));
    for (const fs::path& file :
         {options.extra.stats, options.extra.errorImage, options.extra.explore})
        if (!file.empty()) sw::requireWritable(file);
}

void save(const fs::path& file, const std::string& content) {
    std::error_code none;
    sw::Target target{fs::absolute(file, none), std::nullopt};
    try {
        target = sw::targetOf(file);
        sw::writeFile(file, content);
    } catch (const sw::FileError& error) {
        if (target.stream || target.isSpecial()) throw;
        const fs::path other = saveElsewhere(target.file, content);
        if (other.empty()) throw;
        throw sw::FileError(std::string(error.what()) + "; what it should hold is in " +
                            other.string());
    }
}

void saveBeside(const fs::path& file, const std::function<std::string()>& content,
                std::string& failure) {
    if (file.empty()) return;
    const auto fail = [&](const std::string& reason) {
        failure += (failure.empty() ? "" : "; ") + reason;
    };
    try {
        save(file, content());
    } catch (const sw::FileError& error) {
        fail(error.what());
    } catch (const std::bad_alloc&) {
        if (failure.empty()) throw;  // else the other file's name would get lost
        fail(file.string() + ": too large for memory");
    }
}

std::string savePicture(const sw::Image& image, const Options& options) try {
    const PictureFormat format = formatOf(options.output).value_or(PictureFormat::png);
    save(options.output, encode(image, format, options.gamma));
    return {};
} catch (const sw::FileError& error) {
    return error.what();
}

void printSummary(const std::string& line, const Options& options) {
    for (const fs::path& file :
         {options.output, options.extra.stats, options.extra.errorImage, options.extra.explore})
        if (!file.empty() && sw::targetOf(file).stream == 1) {
            std::cerr << oneLine(line) << std::endl;
            return;
        }
    print(oneLine(line) + "\n");
}
