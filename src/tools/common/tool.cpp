#include "tools/common/tool.h"

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <system_error>

#include "swFile.h"
#include "swNff.h"

namespace report {

int runTool(int argc, const char* const* argv, const char* name, const char* description,
            const std::function<void(CLI::App&)>& setUp) {
    const auto fail = [&](int code, const std::exception& error) {
        std::cerr << name << ": " << error.what() << std::endl;
        return code;
    };
    try {
        CLI::App app(description, name);
        setUp(app);
        try {
            app.parse(argc, argv);  // runs the callbacks
        } catch (const CLI::ParseError& error) {
            if (error.get_exit_code() == 0) return app.exit(error);  // --help
            return fail(2, error);
        }
        return 0;
    } catch (const sw::NffError& error) {
        return fail(3, error);
    } catch (const sw::FileError& error) {
        return fail(4, error);
    } catch (const std::exception& error) {
        return fail(1, error);
    }
}

std::filesystem::path outputFile(const std::filesystem::path& folder, const char* name) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);  // requireWritable reports the error
    const std::filesystem::path file = folder / name;
    sw::requireWritable(file);
    return file;
}

}  // namespace report
