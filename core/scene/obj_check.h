#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/check.h"

namespace ps {

/// A name in a model file and the line in which it is first.
struct ObjReference {
  std::string name;
  int line = 0;
};

/// From this face on (counted from 0) faces belong to a smoothing group; 0 = off.
struct SmoothingChange {
  std::size_t first_face = 0;
  std::uint32_t group = 0;
};

/// What check_obj counted and found on its way.
struct ObjSummary {
  std::size_t positions = 0;
  std::size_t normals = 0;
  std::size_t uvs = 0;
  std::size_t faces = 0;
  std::size_t corners = 0;  ///< of all faces together
  std::vector<ObjReference> material_files;
  std::vector<ObjReference> used_materials;
  std::vector<std::size_t> without_material;  ///< faces (counted from 0) before which a `usemtl` names no material
  std::vector<SmoothingChange> smoothing;     ///< in the order of the file; empty without an `s` other than off
  std::vector<std::string> notes;  ///< what the file holds and nothing draws, with file and line, each kind once
};

/// Reads the text of a Wavefront OBJ file before tinyobjloader does, which takes "v nan" and "v 1 banana 0" without a
/// word and only warns of indices out of range. After this the text is known to be good: every number is finite and
/// at most 1e12, every index lies in its list, every face has 3 to 1000 vertices, and there is at least one face.
/// Joined lines (a backslash at the end), comments behind a statement and a byte-order mark are blanked out in place,
/// since tinyobjloader does not know them. Free-form curves and surfaces are passed over, with a note, where there are
/// faces as well. Throws InputError with line and column.
ObjSummary check_obj(std::string& text, const std::string& file);

/// Largest length of one line in a model or material file, in bytes.
inline constexpr std::size_t max_obj_line = 64 * 1024;

}  // namespace ps
