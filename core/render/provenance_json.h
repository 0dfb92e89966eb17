#pragma once
#include <nlohmann/json.hpp>

#include "render/provenance.h"

namespace ps {

/// {"program", "processor", "simd", "threads", "settings", ...}: as provenance_facts(), the threads as a number.
inline nlohmann::ordered_json provenance_json(const Provenance& provenance) {
  nlohmann::ordered_json json;
  for (const auto& [key, value] : provenance_facts(provenance)) json[key] = value;
  json["threads"] = provenance.threads;
  return json;
}

}  // namespace ps
