#pragma once
#include <filesystem>
#include <map>
#include <string>

#include "scene/mtl_check.h"
#include "scene/obj.h"
#include "scene/obj_reader.h"

namespace ps {

/// Indices into ObjModel::materials.
struct ObjMaterials {
  std::map<std::string, std::uint32_t> by_name;     ///< also by what else `usemtl` may write, see meant_names()
  std::map<std::uint32_t, UvPlacement> placements;  ///< of those whose pictures do not lie as the model says
};

/// Reads the material files that an OBJ file names, in its order, into model.materials, model.textures, model.files and
/// model.warnings. The first of two with one name counts. A file that is missing or not text is a warning, as models
/// often come without theirs.
ObjMaterials load_obj_materials(const std::filesystem::path& obj, const std::vector<ObjReference>& files,
                                ObjModel& model);

/// The same for the text of one material file; textures are looked for beside `path`. Throws InputError for other than
/// text.
ObjMaterials parse_obj_materials(std::string_view text, const std::filesystem::path& path, ObjModel& model);

}  // namespace ps
