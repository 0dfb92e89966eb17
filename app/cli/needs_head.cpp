#include "cli/needs_head.h"

#include <fmt/format.h>

#include "options/scene_settings.h"
#include "render/provenance.h"

namespace ps::cli {

nlohmann::ordered_json needs_head(const Document& document, const std::string& sentence, double tolerance) {
  const Provenance made = provenance_of(document.a.settings);
  return {{"program", made.program},
          {"processor", made.processor},
          {"simd", made.simd},
          {"threads", made.threads},
          {"scene", document.scene_name},
          {"base-settings", made.settings},
          {"sentence", sentence},
          {"metric", "largest mean FLIP of a tile"},
          {"tolerance", tolerance}};
}

void print_made_by(const Document& document) {
  const Provenance made = provenance_of(document.a.settings);
  fmt::print("made by    {}, {}, {}, {} threads{}{}\n", made.program, made.processor, made.simd, made.threads,
             made.settings.empty() ? "" : ", ", made.settings);
}

std::string changed_settings(const Settings& from, const Settings& to) {
  return fmt::format("{}", fmt::join(settings_difference(from, to), ";"));
}

}  // namespace ps::cli
