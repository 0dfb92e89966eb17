#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "scene/mesh.h"

namespace ps {

/// A name in a model file and the line in which it is first.
struct ObjReference {
  std::string name;
  int line = 0;
};

/// The content of an OBJ file, before its material files are read.
struct ObjText {
  /// Triangles hold an index into `materials` as their material. Texture coordinates are turned over. A normal that
  /// cannot be used is (0, 0, 0).
  Mesh mesh;
  std::vector<std::uint32_t> smoothing_groups;  ///< of each triangle, 0 = none; empty where there is none at all
  std::vector<ObjReference> material_files;
  std::vector<ObjReference> materials;  ///< that `usemtl` names; an empty name is "no material"
  /// Statements without effect, and faults in parts that are not needed, with file and line, each kind once.
  std::vector<std::string> notes;
};

/// Reads a Wavefront OBJ file in one pass, keeping of each triangle where it stands. Vertices of faces and their
/// indices must be right: every number finite and at most 1e12, every index in its list, at least one face of 3
/// vertices or more. All else that a picture can do without becomes a note. Throws InputError with line and column.
ObjText read_obj_text(std::string_view text, const std::string& file);

}  // namespace ps
