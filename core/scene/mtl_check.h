#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/check.h"

namespace ps {

/// A picture that a material names: `map_Kd -s 2 2 1 wood panel.png`.
struct MtlTexture {
  std::string name;  ///< as written, blanks included
  int line = 0;
};

/// What check_mtl found out about one material that tinyobjloader does not tell, or cannot tell from its own defaults.
struct MtlFacts {
  bool diffuse = false;            ///< says Kd
  std::optional<int> illum;        ///< 0 to 10
  std::optional<double> dissolve;  ///< d, or 1 - Tr without d: 1 is opaque
  std::optional<double> refraction_index;
  std::optional<MtlTexture> diffuse_map;
  std::optional<MtlTexture> relief_map;  ///< norm, map_Bump or bump: directions, or heights in grey
  double bump = 1;                       ///< -bm of it: how steep heights are
};

/// What check_mtl found in a material file. Of two materials of one name the first counts.
struct MtlSummary {
  std::map<std::string, MtlFacts> materials;
  std::vector<std::string> notes;  ///< what the file asks for and does not get, with file and line, each kind once
};

/// Reads the text of a material file (MTL) before tinyobjloader does: every statement and option known, every number
/// finite and in its range, every statement after a `newmtl`. Comments are blanked out in place. Throws InputError with
/// line and column.
MtlSummary check_mtl(std::string& text, const std::string& file);

}  // namespace ps
