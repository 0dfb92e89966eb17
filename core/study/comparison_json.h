#pragma once
#include <nlohmann/json.hpp>

#include "image/metrics.h"

namespace ps {

/// A Comparison as JSON with the names that `compare` prints, and back.
nlohmann::ordered_json comparison_json(const Comparison& comparison);
/// Throws InputError, or what nlohmann throws, for text that is not a comparison.
Comparison comparison_from_json(const nlohmann::ordered_json& json);

}  // namespace ps
