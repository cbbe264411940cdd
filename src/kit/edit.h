#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "regions.h"

/// Small changes to sources, as a student makes them: a piece of text and what replaces it.
///
///     task: 3
///     says: what the tests answer to this mistake
///     file: src/main.cpp
///     <<<<
///     old lines
///     ====
///     new lines
///     >>>>
///
/// Further blocks, and further files, may follow. Lines before the first file are a heading of
/// `key: value` lines.
namespace kit {

struct Replacement {
    std::string file;  ///< relative to the folder that is edited
    std::string before, after;
};

struct Edit {
    std::string name;  ///< what error messages call it
    int task = 0;      ///< 1..6; 0: not said
    std::string says;  ///< part of a hint; empty: not said
    std::vector<Replacement> replacements;
};

/// @throws KitError
Edit parseEdit(std::string_view text, const std::string& name);

/// Replaces each text, which must occur just once in its file. Changes all files or none.
/// @throws KitError, sw::FileError
void apply(const Edit& edit, const std::filesystem::path& folder);

}  // namespace kit
