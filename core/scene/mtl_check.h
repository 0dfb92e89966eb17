#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/check.h"
#include "scene/mtl_texture.h"

namespace ps {

/// Where a picture lies on a surface: (u, v) with v from the bottom becomes scale * (u, v) + offset.
struct UvPlacement {
  Vec2d scale{1, 1}, offset{0, 0};
  bool operator==(const UvPlacement&) const = default;
};

/// The properties that a material file gives one material; those that it leaves out are absent.
struct MtlFacts {
  std::optional<Vec3d> diffuse, specular, ambient;  ///< Kd, Ks, Ka
  std::optional<double> shininess;                  ///< Ns
  std::optional<int> illum;                         ///< 0 to 10
  std::optional<double> dissolve;                   ///< d, or 1 - Tr without d: 1 is opaque
  std::optional<double> refraction_index;
  std::optional<MtlTexture> diffuse_map;
  std::optional<MtlTexture> relief_map;  ///< norm, map_Bump or bump: directions, or heights in grey
  std::optional<MtlTexture> specular_map, ambient_map, opacity_map;
  std::vector<MtlTexture> reflections;  ///< refl: a sphere, or faces of a cube
  UvPlacement placement;                ///< -s and -o of its pictures, which share their texture coordinates
};

/// The result of check_mtl for a material file. Of two materials of one name the first counts.
struct MtlSummary {
  std::map<std::string, MtlFacts> materials;
  std::vector<std::string> order;  ///< their names as they come in the file
  std::vector<std::string> notes;  ///< what the file asks for and does not get, with file and line, each kind once
};

/// Reads the text of a material file (MTL). A statement that is not known, stands before any material, or has no value
/// that can be used is left out with a note; values out of their range are clamped, with a note, as exporters do write
/// them. Throws InputError for a file that is not text (see ObjLines).
MtlSummary check_mtl(std::string_view text, const std::string& file);

}  // namespace ps
