#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "document/document.h"

namespace ps::cli {

/// What `needs --json` begins with, whether options or the model are weighed: how it was made, the scene, the sentence
/// that a person acts on, the metric and the tolerance.
nlohmann::ordered_json needs_head(const Document& document, const std::string& sentence, double tolerance);

/// Prints what the results were made by, for people: "made by    PROGRAM, PROCESSOR, SIMD, N threads, SETTINGS".
void print_made_by(const Document& document);

/// The settings of `to` that `from` does not have: "shadows=none;samples-per-pixel=4".
std::string changed_settings(const Settings& from, const Settings& to);

}  // namespace ps::cli
