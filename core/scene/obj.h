#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace ps {

/// A model file as it was read: a mesh with its materials and textures. Indices count from 0 within these lists.
struct ObjModel {
  Mesh mesh;  ///< Mesh::materials point into `materials`
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<std::string> files;  ///< the OBJ file, its material files, its textures
  /// Materials and textures that could not be found, and statements without effect, with file and line.
  std::vector<std::string> warnings;
};

/// Reads a Wavefront OBJ file with its MTL files and textures. What a picture can do without is a warning where it is
/// missing or wrong; only the vertices of faces must be right (see obj_reader.h). Faces with more than three vertices
/// are cut into triangles. Texture coordinates are turned over, since OBJ counts v from the bottom and we from the top.
/// Faces of a smoothing group without normals get the mean ones of their vertices. Kd becomes the colour, Ks and Ns the
/// highlight, Ka the ambient colour, map_Kd the texture, d or Tr the transparency; illum says whether there is a
/// highlight, a reflection (as strong as Ks) and refraction (Ni). Throws InputError.
ObjModel load_obj(const std::filesystem::path& path);

/// The same for a text at hand; material files and textures are looked for beside `path`.
ObjModel parse_obj(std::string_view text, const std::filesystem::path& path);

/// A scene of one model alone: framed whole by a camera in front of it (+z), to its right and above it (+y is up), with
/// ambient light of 0.3 and a directional key light of 0.7 from the upper right. A flat model is looked at straight
/// along -z, or, where that would show its edge, from its front side. A warning says if no face is in view, or backs
/// alone.
Scene load_obj_scene(const std::filesystem::path& path);

inline constexpr std::uintmax_t max_obj_bytes = std::uintmax_t{1} << 30;

}  // namespace ps
