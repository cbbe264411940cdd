#include <CLI/CLI.hpp>
#include <exception>
#include <filesystem>
#include <iostream>
#include <system_error>

#include "swFile.h"
#include "tools/bench/parts.h"
#include "tools/bench/picture.h"
#include "tools/common/machine.h"

namespace {

void makeFolder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw sw::FileError(folder.string() + ": cannot be created: " + error.message());
    sw::requireWritable(folder / "bench.json");
}

void run(const bench::Setup& setup) {
    makeFolder(setup.output);
    std::vector<std::string> notes;
    if (!bench::embreesPicture(16)) notes.push_back("Embree 3 is not installed: lines left out");
    if (setup.quick) notes.push_back("--quick: only shows that it runs; the figures mean nothing");

    bench::Lines lines;
    bench::compareLab(setup, lines);
    bench::measureSteps(setup, lines);
    bench::measureLoading(setup, lines);
    bench::compareModels(setup, lines);
    bench::measureGrowth(setup, lines);

    std::cout << report::machine() << "\n\n" << bench::toTable(lines);
    for (const std::string& note : notes) std::cout << "\n" << note << "\n";
    sw::writeFile(setup.output / "bench.json", bench::toJson(lines, report::machine(), notes));
    std::cout << "\n" << (setup.output / "bench.json").string() << std::endl;
}

}  // namespace

// Exit codes: 0 done, 1 unexpected, 2 command line, 4 output.
int main(int argc, char** argv) {
    const auto fail = [](int code, const std::exception& error) {
        std::cerr << "swtracer-bench: " << error.what() << std::endl;
        return code;
    };
    try {
        bench::Setup setup;
        CLI::App app("Compares run times and memory with others; prints ratios.", "swtracer-bench");
        app.add_flag("--quick", setup.quick, "only see whether everything runs");
        app.add_flag("--full", setup.full, "models of 4 and 10 million triangles as well");
        app.add_option("--output", setup.output, "folder for bench.json")->capture_default_str();
        try {
            app.parse(argc, argv);
        } catch (const CLI::ParseError& error) {
            if (error.get_exit_code() == 0) return app.exit(error);  // --help
            return fail(2, error);
        }
        run(setup);
        return 0;
    } catch (const sw::FileError& error) {
        return fail(4, error);
    } catch (const std::exception& error) {
        return fail(1, error);
    }
}
