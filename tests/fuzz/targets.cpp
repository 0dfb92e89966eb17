#include "fuzz/targets.h"
#include "options/scene_settings.h"

#include <array>
#include <cmath>

#include "base/check.h"
#include "fuzz/read_or_refuse.h"
#include "image/file.h"
#include "scene/obj.h"
#include "scene/obj_material.h"
#include "scene/scene_file.h"
#include "scene/scene_writer.h"

namespace ps::fuzz {
namespace {

/// Other files that the bytes name are looked for here.
constexpr const char* folder = "tests/corpus/files";

void check_mesh(const Mesh& mesh, std::size_t materials) {
  for (const Vec3d& p : mesh.positions) PS_ASSERT(std::isfinite(p.x + p.y + p.z), "vertices are finite");
  const auto lies_in = [](std::int32_t index, std::size_t size) {
    return index == -1 || (index >= 0 && static_cast<std::size_t>(index) < size);
  };
  for (const MeshTriangle& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      PS_ASSERT(triangle.position[i] < mesh.positions.size(), "a corner is a vertex");
      PS_ASSERT(lies_in(triangle.normal[i], mesh.normals.size()), "a corner's normal is one of the mesh");
      PS_ASSERT(lies_in(triangle.uv[i], mesh.uvs.size()), "a corner's texture coordinate is one of the mesh");
    }
    PS_ASSERT(triangle.material < mesh.materials.size(), "a triangle has a material");
  }
  for (const std::uint32_t material : mesh.materials) PS_ASSERT(material < materials, "a slot has a material");
}

void check_materials(const std::vector<Material>& materials, std::size_t textures) {
  for (const Material& material : materials) {
    PS_ASSERT(material.texture < static_cast<int>(textures), "a texture is one of the scene");
    PS_ASSERT(material.transparency >= 0 && material.transparency <= 1, "a share of light");
    PS_ASSERT(material.reflective >= 0 && material.reflective <= 1, "a share of light");
    PS_ASSERT(!material.specular || *material.specular > 0, "an exponent");
  }
}

/// What is read can be written, and reads back as the same text.
Outcome scene(std::string_view bytes) {
  return read_or_refuse([&] {
    const Scene first = parse_scene(bytes, "fuzz.scene", folder);
    static_cast<void>(settings_for(first));  // a scene with bad settings is never written
    for (const auto& mesh : first.geometry->meshes) check_mesh(*mesh, first.materials->size());
    check_materials(*first.materials, first.textures->size());
    const std::string text = write_scene(first, folder);
    std::string again;
    try {
      again = write_scene(parse_scene(text, "written.scene", folder), folder);
    } catch (const InputError& error) {
      throw std::logic_error(std::string("what was written cannot be read: ") + error.what() + "\n" + text);
    }
    PS_ASSERT(again == text, "a scene that was written reads back as itself");
  });
}

Outcome obj(std::string_view bytes) {
  return read_or_refuse([&] {
    const ObjModel model = parse_obj(std::string(bytes), std::string(folder) + "/fuzz.obj");
    PS_ASSERT(!model.mesh.triangles.empty(), "a model has triangles");
    check_mesh(model.mesh, model.materials.size());
    check_materials(model.materials, model.textures.size());
  });
}

Outcome mtl(std::string_view bytes) {
  return read_or_refuse([&] {
    ObjModel model;
    parse_obj_materials(std::string(bytes), std::string(folder) + "/fuzz.mtl", model);
    check_materials(model.materials, model.textures.size());
  });
}

Outcome picture(std::string_view bytes, const char* name) {
  return read_or_refuse([&] {
    const StoredPicture read = decode_picture(bytes, name);
    PS_ASSERT(read.colour.width() > 0 && read.colour.height() > 0, "a picture has pixels");
    PS_ASSERT(read.alpha.empty() || read.alpha.pixels().size() == read.colour.pixels().size(), "each has an opacity");
  });
}
Outcome png(std::string_view bytes) { return picture(bytes, "fuzz.png"); }
Outcome pnm(std::string_view bytes) { return picture(bytes, "fuzz.ppm"); }
Outcome pfm(std::string_view bytes) { return picture(bytes, "fuzz.pfm"); }
Outcome jpeg(std::string_view bytes) { return picture(bytes, "fuzz.jpg"); }
Outcome tga(std::string_view bytes) { return picture(bytes, "fuzz.tga"); }

constexpr std::array<Target, 13> table{{{"scene", scene},
                                        {"obj", obj},
                                        {"mtl", mtl},
                                        {"png", png},
                                        {"pnm", pnm},
                                        {"pfm", pfm},
                                        {"jpeg", jpeg},
                                        {"tga", tga},
                                        {"permalink", read_permalink},
                                        {"bundle", read_bundle},
                                        {"chart-log", read_log_of_chart},
                                        {"lesson", read_lesson},
                                        {"own-result", read_own_result}}};

}  // namespace

std::span<const Target> targets() { return table; }

const Target& target(std::string_view name) {
  for (const Target& target : table)
    if (target.name == name) return target;
  PS_ASSERT(false, "the target is in the table");
  return table[0];
}

}  // namespace ps::fuzz
