#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>

#include "swFile.h"
#include "swNff.h"
#include "tools/convergence/convergence.h"
#include "tools/stability/stability.h"

// Exit codes: 0 done, 1 unexpected, 2 command line, 3 scene, 4 output.
int main(int argc, char** argv) {
    const auto fail = [](int code, const std::exception& error) {
        std::cerr << "swtracer-report: " << error.what() << std::endl;
        return code;
    };
    try {
        CLI::App app("Measures error against run time.", "swtracer-report");
        app.require_subcommand(1);
        report::addStability(app);
        report::addConvergence(app);
        try {
            app.parse(argc, argv);  // runs the subcommand
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
