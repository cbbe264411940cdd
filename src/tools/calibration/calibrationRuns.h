#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/common/subject.h"

namespace report {

/// A way to render whose error is printed.
struct Mode {
    enum class Kind { tolerance, targetRmse, timeLimit, grid };
    std::string name;  ///< as on the command line
    Kind kind;
    double value;
};

/// One render: the error that it has, and the one that it states.
struct Statement {
    double trueRmse = 0;
    double printed = 0;
    double standardError = 0;
    double samples = 0;  ///< per pixel
    double seconds = 0;
};

/// All renders of one scene in one mode.
struct CalibrationRow {
    std::string scene;
    Mode mode;
    double referenceError = 0;  ///< estimated RMSE of the reference
    std::vector<Statement> runs;

    /// Whether printed and true error are within a factor of 1.5, or as near as the reference is.
    bool isNear(const Statement& run) const;
    /// Whether the true error lies within three standard errors of the printed one.
    bool isInBand(const Statement& run) const;
    /// Whether the true error is at most 1.2 times the target, if there is one.
    bool meansTarget(const Statement& run) const;
};

/// A converged picture, and how far it is.
struct Reference {
    sw::Image image;
    double error;  ///< estimated RMSE
};

/// Reads a reference of n x n samples from a folder, or renders it and keeps it there.
/// @param text  of the scene: another text has another file
Reference referenceOf(const Subject& subject, const std::string& name, const std::string& text,
                      int n, const std::filesystem::path& folder);

Statement stateError(const Subject& subject, const Mode& mode, std::uint64_t seed,
                     const Reference& reference);

}  // namespace report
