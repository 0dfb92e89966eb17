#include "scene/obj.h"

#include <istream>
#include <streambuf>

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include "math/unit.h"
#include "scene/obj_check.h"
#include "scene/obj_material.h"
#include "scene/polygon.h"
#include "scene/scene_file.h"
#include "scene/smooth_normals.h"

namespace ps {
namespace {

namespace fs = std::filesystem;

/// Lets a stream read from a text without copying it.
class TextBuffer : public std::streambuf {
 public:
  explicit TextBuffer(std::string& text) { setg(text.data(), text.data(), text.data() + text.size()); }
};

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\f\v");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t\f\v") - first + 1));
}

/// Takes what tinyobjloader finds, statement by statement.
class ModelBuilder {
 public:
  ModelBuilder(ObjModel& model, const ObjSummary& summary, ObjMaterials materials)
      : model_(model), smoothing_(summary.smoothing), without_material_(summary.without_material),
        materials_(std::move(materials)) {
    model.mesh.positions.reserve(summary.positions);
    model.mesh.normals.reserve(summary.normals);
    model.mesh.uvs.reserve(summary.uvs);
    model.mesh.triangles.reserve(summary.corners - 2 * summary.faces);
  }

  void read(std::string& text) {
    tinyobj::callback_t callbacks;
    using Real = tinyobj::real_t;
    callbacks.vertex_cb = [](void* self, Real x, Real y, Real z, Real) {
      mesh_of(self).positions.emplace_back(x, y, z);
    };
    callbacks.normal_cb = [](void* self, Real x, Real y, Real z) {
      const Vec3d normal(x, y, z);
      mesh_of(self).normals.push_back(normal == Vec3d(0) ? normal : float_direction(normal));
    };
    callbacks.texcoord_cb = [](void* self, Real u, Real v, Real) { mesh_of(self).uvs.emplace_back(u, 1 - v); };
    callbacks.index_cb = [](void* self, tinyobj::index_t* corners, int count) {
      static_cast<ModelBuilder*>(self)->face(corners, count);
    };
    callbacks.usemtl_cb = [](void* self, const char* name, int) {
      static_cast<ModelBuilder*>(self)->use_material(trimmed(name));
    };
    TextBuffer buffer(text);
    std::istream stream(&buffer);
    std::string warnings, errors;
    tinyobj::LoadObjWithCallback(stream, callbacks, this, nullptr, &warnings, &errors);
    PS_ASSERT(errors.empty(), "obj_check leaves tinyobjloader nothing to complain about");
    cut_polygons();
    drop_incomplete_normals();
    place_uvs();
    if (!groups_.empty()) add_smooth_normals(model_.mesh, groups_);
  }

 private:
  static Mesh& mesh_of(void* self) { return static_cast<ModelBuilder*>(self)->model_.mesh; }

  /// Positive indices count from 1; negative ones back from what has been read so far; 0 = not given.
  static std::int32_t resolve(int index, std::size_t count) {
    return index >= 0 ? index - 1 : static_cast<std::int32_t>(count) + index;
  }

  void face(const tinyobj::index_t* corners, int count) {
    corners_.clear();
    for (int i = 0; i < count; ++i) {
      corners_.push_back({resolve(corners[i].vertex_index, model_.mesh.positions.size()),
                          resolve(corners[i].normal_index, model_.mesh.normals.size()),
                          resolve(corners[i].texcoord_index, model_.mesh.uvs.size())});
    }
    if (!slot_ || material_ends()) use_material({});
    if (count == 3) {
      add(0, 1, 2);
    } else {
      // Vertices may follow later in the file, so the shape of a polygon is known only at its end.
      polygons_.push_back({model_.mesh.triangles.size(), corners_.size()});
      for (std::size_t i = 1; i + 1 < corners_.size(); ++i) add(0, i, i + 1);
    }
    if (!smoothing_.empty()) groups_.resize(model_.mesh.triangles.size(), smoothing_group());
    ++faces_;
  }

  /// Whether a `usemtl` without a name, which tinyobjloader does not report, is before the face that is being read.
  bool material_ends() {
    const std::size_t before = next_end_;
    while (next_end_ < without_material_.size() && without_material_[next_end_] <= faces_) ++next_end_;
    return next_end_ > before;
  }

  /// Of the face that is being read.
  std::uint32_t smoothing_group() {
    while (next_change_ < smoothing_.size() && smoothing_[next_change_].first_face <= faces_) ++next_change_;
    return next_change_ == 0 ? 0 : smoothing_[next_change_ - 1].group;
  }

  void add(std::size_t a, std::size_t b, std::size_t c) {
    MeshTriangle triangle;
    const std::array<std::size_t, 3> order{a, b, c};
    for (std::size_t i = 0; i < 3; ++i) set_corner(triangle, i, corners_[order[i]]);
    triangle.material = *slot_;
    model_.mesh.triangles.push_back(triangle);
  }

  struct Corner {
    std::int32_t position, normal, uv;
  };
  static void set_corner(MeshTriangle& triangle, std::size_t i, const Corner& corner) {
    triangle.position[i] = static_cast<std::uint32_t>(corner.position);
    triangle.normal[i] = corner.normal;
    triangle.uv[i] = corner.uv;
  }
  static Corner corner_of(const MeshTriangle& triangle, std::size_t i) {
    return {static_cast<std::int32_t>(triangle.position[i]), triangle.normal[i], triangle.uv[i]};
  }

  /// Replaces the fans that face() made by a triangulation that also holds for polygons that are not convex.
  void cut_polygons() {
    std::vector<Vec3d> points;
    for (const Polygon& polygon : polygons_) {
      MeshTriangle* fan = &model_.mesh.triangles[polygon.first_triangle];
      corners_.assign({corner_of(fan[0], 0), corner_of(fan[0], 1)});
      for (std::size_t i = 0; i + 2 < polygon.corners; ++i) corners_.push_back(corner_of(fan[i], 2));
      points.clear();
      for (const Corner& corner : corners_)
        points.push_back(model_.mesh.positions[static_cast<std::size_t>(corner.position)]);
      const auto triangles = triangulate_polygon(points);
      for (std::size_t i = 0; i < triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) set_corner(fan[i], k, corners_[triangles[i][k]]);
    }
  }

  /// A triangle has three vertex normals or none; exporters write (0, 0, 0) for degenerate faces, which is none.
  void drop_incomplete_normals() {
    const Mesh& mesh = model_.mesh;
    for (MeshTriangle& triangle : model_.mesh.triangles) {
      for (const std::int32_t normal : triangle.normal) {
        const bool good = normal >= 0 && mesh.normals[static_cast<std::size_t>(normal)] != Vec3d{0, 0, 0};
        if (good) continue;
        triangle.normal = {-1, -1, -1};
        break;
      }
      for (const std::int32_t uv : triangle.uv) {
        if (uv >= 0) continue;
        triangle.uv = {-1, -1, -1};
        break;
      }
    }
  }

  /// Moves the texture coordinates of each triangle as its material's pictures lie. They count v from the bottom.
  void place_uvs() {
    if (materials_.placements.empty()) return;
    std::map<std::pair<std::uint32_t, std::int32_t>, std::int32_t> placed;
    for (MeshTriangle& triangle : model_.mesh.triangles) {
      const auto placement = materials_.placements.find(model_.mesh.materials[triangle.material]);
      if (placement == materials_.placements.end() || triangle.uv[0] < 0) continue;
      const auto& [scale, offset] = placement->second;
      for (std::int32_t& uv : triangle.uv) {
        const auto [known, is_new] =
            placed.try_emplace({placement->first, uv}, static_cast<std::int32_t>(model_.mesh.uvs.size()));
        const Vec2d old = model_.mesh.uvs[static_cast<std::size_t>(uv)];
        if (is_new) model_.mesh.uvs.emplace_back(scale.x * old.x + offset.x, 1 - (scale.y * (1 - old.y) + offset.y));
        uv = known->second;
      }
    }
  }

  void use_material(const std::string& name) {
    const auto [slot, is_new] = slots_.try_emplace(name, static_cast<std::uint32_t>(slots_.size()));
    slot_ = slot->second;
    if (!is_new) return;
    const auto known = materials_.by_name.find(name);
    if (known != materials_.by_name.end()) {
      model_.mesh.materials.push_back(known->second);
      return;
    }
    model_.mesh.materials.push_back(static_cast<std::uint32_t>(model_.materials.size()));
    Material plain;
    plain.name = name;
    plain.colour = {0.8, 0.8, 0.8};
    model_.materials.push_back(std::move(plain));
  }

  struct Polygon {
    std::size_t first_triangle, corners;
  };
  ObjModel& model_;
  const std::vector<SmoothingChange>& smoothing_;
  std::size_t next_change_ = 0;
  const std::vector<std::size_t>& without_material_;
  std::size_t next_end_ = 0;
  std::size_t faces_ = 0;
  std::vector<std::uint32_t> groups_;  ///< smoothing group of each triangle; empty if there is none
  ObjMaterials materials_;
  std::map<std::string, std::uint32_t> slots_;
  std::optional<std::uint32_t> slot_;
  std::vector<Corner> corners_;
  std::vector<Polygon> polygons_;
};

}  // namespace

ObjModel load_obj(const fs::path& path) { return parse_obj(read_text_file(path, max_obj_bytes), path); }

ObjModel parse_obj(std::string text, const fs::path& path) {
  ObjModel model;
  const ObjSummary summary = check_obj(text, path.string());
  model.files.push_back(path.string());
  model.warnings = summary.notes;
  auto materials = load_obj_materials(path, summary.material_files, model);
  for (const ObjReference& used : summary.used_materials) {
    if (materials.by_name.count(used.name) > 0) continue;
    constexpr std::size_t most_warnings = 20;
    if (model.warnings.size() < most_warnings)
      model.warnings.push_back(
          fmt::format("{}:{}: the material '{}' is missing.", path.string(), used.line, used.name));
  }
  model.mesh.name = path.stem().string();
  model.mesh.source = path.string();
  ModelBuilder(model, summary, std::move(materials)).read(text);
  return model;
}

}  // namespace ps
