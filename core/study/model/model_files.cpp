#include "study/model/model_files.h"

#include <optional>
#include <set>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "frame/display_frame.h"
#include "image/difference.h"
#include "image/display.h"
#include "image/file.h"
#include "options/scene_settings.h"
#include "scene/scene_writer.h"
#include "study/picture_sheet.h"
#include "study/study_frame.h"

namespace ps {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_spelled_out = 32;  ///< triangles of a model that a scene file lists itself

/// A name as a part of a file's name.
std::string file_part(const std::string& name, std::size_t index) {
  std::string part;
  for (const char c : name)
    part += (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ? c : '-';
  return part.empty() ? fmt::format("{}", index) : part;
}

/// A path beside the scene's file that no file of this scene has yet.
class FilesBeside {
 public:
  explicit FilesBeside(const fs::path& path) : path_(path) {}
  fs::path next(const std::string& name, std::size_t index, std::string_view extension) {
    std::string file = fmt::format("{}-{}", path_.stem().string(), file_part(name, index));
    if (!taken_.insert(file + std::string(extension)).second) file += fmt::format("-{}", index);
    taken_.insert(file + std::string(extension));
    return path_.parent_path() / (file + std::string(extension));
  }

 private:
  fs::path path_;
  std::set<std::string> taken_;
};

Image<Rgb8> drawn(const Scene& scene, const View& view, const Settings& settings, WorkerPriority priority,
                  StudyControl& control) {
  Prepared prepared;
  return display_frame(study_frame(scene, view, settings, control, priority, prepared), settings);
}

}  // namespace

Image<Rgb8> before_and_after(const ModelRequest& request, const ModelNeeds& needs, StudyControl& control) {
  std::vector<std::vector<Image<Rgb8>>> rows;
  for (const View& view : request.views)
    for (const auto& by : {model::HeldPictures::by_rays, model::HeldPictures::by_fragments}) {
      Image<Rgb8> full = drawn(request.scene, view, by(request.base), request.priority, control);
      Image<Rgb8> less = drawn(needs.scene, view, by(needs.settings), request.priority, control);
      const DifferenceNumbers numbers = difference_numbers(difference_values(full, less, DifferenceMode::absolute));
      Image<Rgb8> apart = difference_picture(full, less, {gain_that_shows(numbers, DifferenceMode::absolute)});
      std::vector<Image<Rgb8>>& row = rows.emplace_back();
      row.push_back(std::move(full));
      row.push_back(std::move(less));
      row.push_back(std::move(apart));
    }
  return picture_sheet(rows);
}

std::string obj_text(const Mesh& mesh) {
  std::string text;
  for (const Vec3d& p : mesh.positions) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
  for (const Vec2d& uv : mesh.uvs) text += fmt::format("vt {} {}\n", uv.x, 1 - uv.y);
  for (const Vec3d& n : mesh.normals) text += fmt::format("vn {} {} {}\n", n.x, n.y, n.z);
  std::optional<std::uint32_t> slot;
  for (const MeshTriangle& triangle : mesh.triangles) {
    if (slot != triangle.material) text += fmt::format("usemtl slot{}\n", triangle.material);
    slot = triangle.material;
    text += "f";
    for (std::size_t k = 0; k < 3; ++k) {
      const auto from_1 = [](std::int32_t index) { return index < 0 ? "" : fmt::format("{}", index + 1); };
      text += fmt::format(" {}/{}/{}", triangle.position[k] + 1, from_1(triangle.uv[k]), from_1(triangle.normal[k]));
    }
    text += '\n';
  }
  return text;
}

void save_reduced(const ModelNeeds& needs, const View& view, const fs::path& path) {
  Scene scene = needs.scene;
  scene.camera = view.camera;
  scene.canvas_width = view.width;
  scene.canvas_height = view.height;
  if (scene.start_pixel.x >= view.width || scene.start_pixel.y >= view.height) scene.start_pixel = {-1, -1};
  scene.settings.clear();
  for (const std::string& assignment : settings_difference(Settings{}, needs.settings)) {
    const auto equals = assignment.find('=');
    scene.settings.push_back({assignment.substr(0, equals), assignment.substr(equals + 1)});
  }
  FilesBeside files(path);
  scene.geometry.edit([&](Geometry& geometry) {
    for (std::size_t i = 0; i < geometry.meshes.size(); ++i) {
      const Mesh& mesh = *geometry.meshes[i];
      if (!mesh.source.empty() || !mesh.patches.empty() || mesh.triangles.size() <= most_spelled_out) continue;
      Mesh saved = mesh;
      saved.source = files.next(mesh.name, i, ".obj").string();
      write_file_atomically(saved.source, obj_text(mesh));
      geometry.meshes[i] = std::make_shared<const Mesh>(std::move(saved));
    }
  });
  scene.textures.edit([&](std::vector<Texture>& textures) {
    for (std::size_t i = 0; i < textures.size(); ++i) {
      Texture& texture = textures[i];
      if (!texture.path.empty() || !texture.faces.empty() || !texture.generator.empty()) continue;
      texture.path = files.next(texture.name, i, ".png").string();
      save_image(texture.path, display_image(*texture.texels));
    }
  });
  save_scene(scene, path);
}

}  // namespace ps
