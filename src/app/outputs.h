#pragma once

#include <functional>
#include <string>

#include "app/options.h"
#include "swImage.h"

/// Checks what the files of a command line are, and the standard streams, before any is read or
/// written.
/// @return  the options, with names of standard streams for "-"
/// @throws UsageError for an output that is the scene, another output, or somebody's work
///         of another kind, sw::FileError for one that cannot be told
Options checkFiles(Options options);

/// Checks that the outputs can be written, as far as that is known before the work.
/// @param options  with a size set by settleSize()
/// @throws sw::FileError
void requireOutputs(const Options& options);

/// Writes a file; if that fails, another one beside it or in the system's folder for temporary
/// files.
/// @throws sw::FileError, also when the other file was written; the message names it
void save(const std::filesystem::path& file, const std::string& content);

/// Saves what comes beside the picture.
/// @param content  makes it; not called without a file
/// @param failure  what went wrong so far, such as a picture under another name; receives more
/// @throws std::bad_alloc  if memory ends, and nothing went wrong before that
void saveBeside(const std::filesystem::path& file, const std::function<std::string()>& content,
                std::string& failure);

/// Saves the picture in the form that its name says.
/// @return  what went wrong; empty: nothing
std::string savePicture(const sw::Image& image, const Options& options);

/// Prints the summary: on stdout unless that takes an output.
/// @throws sw::FileError
void printSummary(const std::string& line, const Options& options);
