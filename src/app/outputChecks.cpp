// checkFiles() of outputs.h.
#include <cctype>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <vector>

#include "app/outputs.h"
#include "app/pictureFormat.h"
#include "app/process.h"
#include "files/failure.h"
#include "files/target.h"
#include "files/temporary.h"
#include "files/utf8Path.h"
#include "swFile.h"

namespace {

namespace fs = std::filesystem;

struct Output {
    const char* option;
    fs::path name;
    sw::Target target;

    bool isFile() const { return !target.stream && !target.isSpecial(); }
};

std::vector<Output> outputsOf(const Options& options) {
    std::vector<Output> outputs;
    const auto add = [&](const char* option, const fs::path& name) {
        if (!name.empty()) outputs.push_back({option, name, sw::targetOf(name)});
    };
    add("-o", options.output);
    add("--stats", options.extra.stats);
    add("--error-image", options.extra.errorImage);
    add("--explore", options.extra.explore);
    return outputs;
}

// Whether two names lead to the same regular file that exists: by links, or in another case.
bool isSameFile(const fs::path& a, const fs::path& b) {
    std::error_code none;
    return fs::is_regular_file(a, none) && fs::exists(b, none) && fs::equivalent(a, b, none);
}

std::string lowerCase(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

// Whether names in a file's folder are the same in upper and lower case. A file tells.
bool ignoresCase(const fs::path& file) {
    try {
        const sw::Temporary probe(file, file);
        fs::path otherCase = probe.path;
        std::error_code none;
        return fs::exists(otherCase.replace_extension(".TMP"), none);
    } catch (const sw::FileError&) {
        return false;  // and nothing will be written there
    }
}

bool isSameOutput(const Output& a, const Output& b) {
    const fs::path &one = a.target.file, &other = b.target.file;
    if (a.target.stream && a.target.stream == b.target.stream) return true;
    if (isSameFile(one, other)) return true;
    if (!a.isFile() || !b.isFile()) return false;
    return one == other ||
           (lowerCase(one.string()) == lowerCase(other.string()) && ignoresCase(one));
}

void refuseSameFiles(const std::vector<Output>& outputs, const fs::path& scene) {
    const auto refuse = [](const std::string& one, const Output& other) {
        throw UsageError(one + " and " + other.option + " are the same file, " +
                         other.name.string() + "; expected two different ones");
    };
    for (const Output& output : outputs)
        if (isSameFile(scene, output.target.file)) refuse("scene", output);
    for (std::size_t i = 0; i < outputs.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (isSameOutput(outputs[j], outputs[i])) refuse(outputs[j].option, outputs[i]);
}

// Pictures get the form that their names say, and no other.
void requireEnding(const Output& output, bool pngOnly) {
    std::error_code none;
    if (!output.isFile() || fs::is_directory(output.target.file, none)) return;
    const auto format = formatOf(output.name);
    if (format && (!pngOnly || format == PictureFormat::png)) return;
    throw UsageError(std::string(output.option) + ": expected a name that ends in " +
                     (pngOnly ? ".png" : ".png, .pfm or .hdr") + ", found " + output.name.string() +
                     " (" + fs::path(output.name).replace_extension(".png").string() + "?)");
}

// Other pictures hold linear values.
void requireGammaOfPng(const Options& options) {
    if (options.gamma != Options().gamma &&
        formatOf(options.output).value_or(PictureFormat::png) != PictureFormat::png)
        throw UsageError("--gamma: expected a PNG beside it, found " + options.output.string() +
                         ", which holds linear values");
}

// Pages are recognised by their ending and by their first words.
void requirePage(const Output& output) {
    const std::string ending = lowerCase(output.name.extension().string());
    if (!output.isFile() || ending == ".html" || ending == ".htm") return;
    throw UsageError("--explore: expected a name that ends in .html, found " +
                     output.name.string() + " (" +
                     fs::path(output.name).replace_extension(".html").string() + "?)");
}

bool isPage(const std::string& start) {
    return lowerCase(start).starts_with("<!doctype html");
}

bool isJson(const std::string& start) {
    const std::size_t first = start.find_first_not_of(" \t\r\n");
    return first != std::string::npos && start[first] == '{';
}

// An empty file is nobody's work.
void requireOwnKind(const Output& output) {
    std::error_code none;
    if (!output.isFile() || !fs::is_regular_file(output.target.file, none)) return;
    errno = 0;
    std::ifstream in(output.target.file, std::ios::binary);
    if (!in) sw::failToWrite(output.name, sw::reasonOf(errno));
    std::string start(64, '\0');
    in.read(start.data(), static_cast<std::streamsize>(start.size()));
    start.resize(static_cast<std::size_t>(in.gcount()));
    const std::string option = output.option;
    const bool json = option == "--stats", page = option == "--explore";
    if (start.empty() || (json ? isJson(start) : page ? isPage(start) : isPicture(start))) return;
    throw UsageError(option + ": " + output.name.string() + " exists and is no " +
                     (json   ? "JSON"
                      : page ? "page"
                             : "picture") +
                     "; expected a new name (or --force to replace it)");
}

}  // namespace

Options checkFiles(Options options) {
    prepareProcess();
    for (fs::path* name :
         {&options.scene, &options.output, &options.extra.stats, &options.extra.errorImage})
        *name = sw::readAsUtf8(*name);
    if (options.scene == "-") options.scene = "/dev/stdin";
    if (options.pixel) return options;
    for (fs::path* name :
         {&options.output, &options.extra.stats, &options.extra.errorImage, &options.extra.explore})
        if (*name == "-") *name = "/dev/stdout";
    const std::vector<Output> outputs = outputsOf(options);
    refuseSameFiles(outputs, options.scene);
    requireGammaOfPng(options);
    for (const Output& output : outputs) {
        const std::string option = output.option;
        if (option == "--explore")
            requirePage(output);
        else if (option != "--stats")
            requireEnding(output, option == "--error-image");
        if (!options.extra.force) requireOwnKind(output);
    }
    return options;
}
