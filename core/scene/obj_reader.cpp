#include "scene/obj_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "base/input_errors.h"
#include "base/number_text.h"
#include "base/spelling.h"
#include "math/unit.h"
#include "scene/obj_line.h"
#include "scene/polygon.h"

namespace ps {
namespace {

constexpr std::size_t most_obj_line = std::size_t{4} << 20;  // a face of some 200,000 vertices
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Statements that are not about the surface, or not about a part that Pixelscope draws.
constexpr std::array<std::string_view, 11> ignored_words{
    "mg", "vp", "vw", "bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj", "usemap", "maplib"};
constexpr std::array<std::string_view, 11> drawn_words{"v", "vt", "vn", "f",      "s",     "o",
                                                       "g", "l",  "p",  "usemtl", "mtllib"};
/// Free-form curves and surfaces, which programs for construction write beside faces.
constexpr std::array<std::string_view, 17> free_form{"cstype", "deg",  "bmat",  "step",  "curv", "curv2",
                                                     "surf",   "parm", "trim",  "hole",  "scrv", "sp",
                                                     "end",    "con",  "ctech", "stech", "bsp"};

bool is_in(const auto& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// One vertex of a face: indices from 0; -1 = none. They may lie behind the end of their lists.
struct FaceCorner {
  std::int64_t position = 0;
  std::int32_t uv = -1, normal = -1;
};

/// A word of digits, perhaps behind a sign; nullopt for anything else.
std::optional<std::int64_t> read_index(std::string_view word) {
  const bool is_negative = word.starts_with('-');
  if (is_negative || word.starts_with('+')) word.remove_prefix(1);
  if (word.empty()) return {};
  constexpr std::int64_t behind_any_list = 1'000'000'000'000;
  std::int64_t value = 0;
  for (const char c : word) {
    if (c < '0' || c > '9') return {};
    value = std::min(value * 10 + (c - '0'), behind_any_list);
  }
  return is_negative ? -value : value;
}

[[noreturn]] void fail_index(const ObjLine& line, std::int64_t index, std::size_t count) {
  const std::string expected =
      count == 0
          ? fmt::format("no vertex index, since there are none {}", index < 0 ? "before this line" : "in the file")
      : index < 0 ? fmt::format("a vertex index of at least -{}, counted back from this line", count)
                  : fmt::format("a vertex index of at most {}", count);
  line.fail(fmt::format("index {} in {}", index, line.shown()), expected);
}

/// The position of a corner as the file counts it: never 0.
std::int64_t position_index(const ObjLine& line, std::string_view word) {
  const auto index = read_index(word);
  if (!index) line.fail(line.shown(), "a vertex reference such as 1, 1/2, 1//3 or 1/2/3");
  if (*index == 0) line.fail(line.shown(), "an index from 1 up, or below 0 to count backwards");
  return *index;
}

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& file) : text_(text), file_(file), mesh_(result_.mesh) {
    mesh_.origins.names.emplace_back();  // of faces before any name
  }

  ObjText run() {
    ObjLines lines(text_, file_, most_obj_line);
    FaultGatherer faults;
    while (auto line = lines.next()) faults.gather([&] { statement(*line); });
    faults.throw_all();
    require_faces(lines.count());
    require_positions();
    cut_polygons();
    mesh_.origins.file_normals = static_cast<std::uint32_t>(mesh_.normals.size());
    mesh_.origins.file_uvs = static_cast<std::uint32_t>(mesh_.uvs.size());
    drop_unusable_indices();
    return std::move(result_);
  }

 private:
  void statement(ObjLine& line) {
    const std::string_view word = line.next();
    if (word.empty()) return;
    if (word == "v") return position(line);
    if (word == "vn") return normal(line);
    if (word == "vt") return uv(line);
    if (word == "f" || word == "fo") return face(line);  // fo is the old form
    if (word == "s") return smoothing(line);
    if (word == "o") return name_faces(line, object_);
    if (word == "g") return name_faces(line, group_);
    if (word == "l") return note("lines are not drawn", line);
    if (word == "p") return note("points are not drawn", line);
    if (word == "t") return note("tags of subdivision surfaces are not drawn", line);
    if (word == "usemtl") return material(line);
    if (word == "mtllib") return material_file(line);
    if (is_in(free_form, word)) return not_polygons(line, "free-form curves and surfaces are not drawn");
    if (word == "call" || word == "csh") return not_polygons(line, "other files and programs are not run");
    if (!is_in(ignored_words, word)) unknown(line, word);
  }

  // ---- Vertices
  // ------------------------------------------------------------------------------------------------------

  /// x y z, then perhaps w, or a colour, or both. A place that cannot be read is an error only if a face uses it.
  void position(ObjLine& line) {
    Vec3d place;
    for (int axis = 0; axis < 3; ++axis) {
      const ObjNumber number = read_obj_number(line.next());
      place[axis] = number.fault == nullptr ? number.value : no_number;
    }
    if (is_absent(place)) note("a vertex without three numbers is left out, as no face uses it", line);
    mesh_.positions.push_back(place);
    int more = 0;
    while (!line.next().empty()) ++more;
    if (more >= 3) note("vertex colours are not drawn", line);
  }
  static bool is_absent(const Vec3d& place) { return std::isnan(place.x + place.y + place.z); }

  void normal(ObjLine& line) {
    Vec3d direction{0, 0, 0};
    bool is_good = true;
    for (int axis = 0; axis < 3; ++axis) is_good = read_number(line, direction[axis]) && is_good;
    if (!is_good) {
      direction = {0, 0, 0};
      note("a normal without three numbers is taken for none", line);
    }
    if (!line.at_end()) note("a normal has three numbers; what follows is not used", line);
    mesh_.normals.push_back(direction == Vec3d{0, 0, 0} ? direction : float_direction(direction));
  }

  /// u, then perhaps v and w.
  void uv(ObjLine& line) {
    Vec2d place{0, 0};
    double depth = 0;
    bool is_good = read_number(line, place.x);
    if (!line.at_end()) is_good = read_number(line, place.y) && is_good;
    if (!line.at_end()) read_number(line, depth);
    if (!is_good) {
      place.x = no_number;
      note("a texture coordinate that is not a number is taken for none", line);
    }
    if (!line.at_end()) note("a texture coordinate has at most three numbers; what follows is not used", line);
    mesh_.uvs.emplace_back(place.x, 1 - place.y);
  }

  static bool read_number(ObjLine& line, double& value) {
    const ObjNumber number = read_obj_number(line.next());
    if (number.fault == nullptr) value = number.value;
    return number.fault == nullptr;
  }

  // ---- Faces
  // ---------------------------------------------------------------------------------------------------------

  void face(ObjLine& line) {
    corners_.clear();
    for (std::string_view word = line.next(); !word.empty(); word = line.next()) corners_.push_back(corner(line, word));
    const std::size_t count = corners_.size();
    if (count < 3) {
      skip(line.error(fmt::format("a face with {} {}", count, count == 1 ? "vertex" : "vertices"),
                      "at least 3 vertices"));
      return note("faces with fewer than 3 vertices are not drawn", line);
    }
    for (const FaceCorner& corner : corners_) largest_position_ = std::max(largest_position_, corner.position);
    if (!slot_) slot_ = slot_of({}, line);
    const std::size_t before = mesh_.triangles.size();
    // Vertices may follow later in the file, so the shape of a polygon is known only at its end.
    if (count > 3) polygons_.push_back({before, count});
    for (std::size_t i = 1; i + 1 < count; ++i) add(corners_[0], corners_[i], corners_[i + 1]);
    mesh_.origins.lines.resize(mesh_.triangles.size(), static_cast<std::uint32_t>(line.number()));
    auto& runs = mesh_.origins.runs;
    if (runs.empty() || runs.back().object != object_ || runs.back().group != group_)
      runs.push_back({static_cast<std::uint32_t>(before), object_, group_});
    auto& groups = result_.smoothing_groups;
    if (smoothing_ > 0) groups.resize(before, 0);
    if (smoothing_ > 0 || !groups.empty()) groups.resize(mesh_.triangles.size(), smoothing_);
  }

  /// v, v/vt, v//vn or v/vt/vn.
  FaceCorner corner(const ObjLine& line, std::string_view word) {
    const auto first = word.find('/');
    FaceCorner corner;
    const std::int64_t index = position_index(line, word.substr(0, first));
    const auto count = static_cast<std::int64_t>(mesh_.positions.size());
    if (index < -count) fail_index(line, index, mesh_.positions.size());
    corner.position = index < 0 ? count + index : index - 1;
    if (first == std::string_view::npos) return corner;
    if (word.back() == '/') note("a slash with nothing behind it is taken for no index", line);
    const std::string_view behind = word.substr(first + 1);
    const auto second = behind.find('/');
    corner.uv = optional_index(line, behind.substr(0, second), mesh_.uvs.size(), no_such_uv);
    if (second != std::string_view::npos)
      corner.normal = optional_index(line, behind.substr(second + 1), mesh_.normals.size(), no_such_normal);
    return corner;
  }

  /// From 0; -1 where there is none, or none that can be used. It may lie behind the end of its list.
  std::int32_t optional_index(const ObjLine& line, std::string_view word, std::size_t count, const char* miss) {
    if (word.find_first_not_of('/') == std::string_view::npos) return -1;
    const std::int64_t index = read_index(word).value_or(0);
    const std::int64_t from_0 = index < 0 ? static_cast<std::int64_t>(count) + index : index - 1;
    if (from_0 >= 0 && from_0 < std::numeric_limits<std::int32_t>::max()) return static_cast<std::int32_t>(from_0);
    note(miss, line);
    return -1;
  }
  static constexpr const char* no_such_uv = "an index of a texture coordinate that is not there is taken for none";
  static constexpr const char* no_such_normal = "an index of a normal that is not there is taken for none";

  void add(const FaceCorner& a, const FaceCorner& b, const FaceCorner& c) {
    MeshTriangle triangle;
    std::size_t i = 0;
    for (const FaceCorner* corner : {&a, &b, &c}) {
      triangle.position[i] = static_cast<std::uint32_t>(corner->position);
      triangle.normal[i] = corner->normal;
      triangle.uv[i++] = corner->uv;
    }
    triangle.material = *slot_;
    mesh_.triangles.push_back(triangle);
  }

  // ---- What holds for the faces that follow
  // --------------------------------------------------------------------------

  /// Any whole number names a group, as do the words of some programs; 0 and off end it.
  void smoothing(ObjLine& line) {
    const std::string_view word = line.next();
    std::string small(word);
    for (char& c : small)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    const auto number = small == "on" ? std::optional<double>(1) : parse_number(word);
    smoothing_ = 0;
    if (word.empty()) return note("'s' without a smoothing group is taken for 's off'", line);
    if (!number && small != "off") note("a smoothing group that is neither a number nor on is taken for off", line);
    if (!line.at_end()) note("a face has one smoothing group; what follows it is not used", line);
    if (number.value_or(0) == 0) return;
    smoothing_ = smoothing_numbers_.try_emplace(*number, smoothing_numbers_.size() + 1).first->second;
  }

  void name_faces(ObjLine& line, std::uint32_t& id) {
    const std::string name(line.name());
    auto& names = mesh_.origins.names;
    if (name.empty()) {
      id = 0;
      return;
    }
    const auto [known, is_new] = name_ids_.try_emplace(name, static_cast<std::uint32_t>(names.size()));
    if (is_new) names.push_back(name);
    id = known->second;
  }

  /// usemtl NAME; without a name, what follows has none.
  void material(ObjLine& line) {
    const std::string name(line.name());
    slot_.reset();
    if (name.empty()) return note("'usemtl' without a name is taken for no material", line);
    slot_ = slot_of(name, line);
  }

  std::uint32_t slot_of(const std::string& name, const ObjLine& line) {
    const auto [slot, is_new] = slots_.try_emplace(name, static_cast<std::uint32_t>(slots_.size()));
    if (is_new) result_.materials.push_back({name, line.number()});
    return slot->second;
  }

  void material_file(ObjLine& line) {
    const std::string name(line.name());
    if (name.empty()) return note("'mtllib' without a name is left out", line);
    constexpr std::size_t most_files = 1000;
    if (known_files_.size() >= most_files) return note("this and further material files are left out", line);
    if (known_files_.insert(name).second) result_.material_files.push_back({name, line.number()});
  }

  // ---- What is left out
  // ----------------------------------------------------------------------------------------------

  void not_polygons(const ObjLine& line, const char* what) {
    skip(line.error(fmt::format("'{}', which is not about polygons", line.word()),
                    "a model of polygons (v, vt, vn, f)"));
    note(what, line);
  }

  void unknown(const ObjLine& line, std::string_view word) {
    constexpr std::size_t most_notes = 20;  // a file of another kind has only unknown words
    if (unknown_.size() >= most_notes || !unknown_.insert(std::string(word)).second) return;
    const std::string_view similar = similar_word(word, {drawn_words.begin(), drawn_words.end()});
    const std::string hint = similar.empty() ? "" : fmt::format("'{}'", similar);
    skip(line.error(line.shown(), similar.empty() ? "a statement of model files, such as v, vt, vn or f" : hint));
    result_.notes.push_back(fmt::format("{}:{}: {} is not a statement of a model file{}.", file_, line.number(),
                                        line.shown(), similar.empty() ? "" : "; perhaps " + hint));
  }

  /// The reason for which a model without any face is refused.
  void skip(const InputError& error) {
    if (!first_skipped_) first_skipped_ = error;
  }

  void note(const char* what, const ObjLine& line) { note(what, line.number()); }
  void note(const char* what, int line) {
    if (is_in(noted_, what)) return;
    noted_.emplace_back(what);
    result_.notes.push_back(fmt::format("{}:{}: {}.", file_, line, what));
  }

  // ---- At the end of the file
  // ----------------------------------------------------------------------------------------

  void require_faces(int lines) const {
    if (!mesh_.triangles.empty()) return;
    for (std::size_t i = 0; i < mesh_.positions.size(); ++i)
      if (is_absent(mesh_.positions[i])) fail_at_vertex(i);
    if (first_skipped_) throw InputError(*first_skipped_);
    throw InputError({file_, lines, 0}, fmt::format("no face in {} lines", lines), "at least one line 'f 1 2 3'");
  }

  /// Every vertex of a face has a place.
  void require_positions() {
    if (largest_position_ >= static_cast<std::int64_t>(mesh_.positions.size())) fail_at_large_indices();
    std::set<std::uint32_t> absent;
    for (const MeshTriangle& triangle : mesh_.triangles)
      for (const std::uint32_t position : triangle.position)
        if (is_absent(mesh_.positions[position])) absent.insert(position);
    FaultGatherer faults;
    for (const std::uint32_t position : absent) faults.gather([&] { fail_at_vertex(position); });
    faults.throw_all();
    for (Vec3d& place : mesh_.positions)
      if (is_absent(place)) place = mesh_.positions[mesh_.triangles[0].position[0]];
  }

  /// The file is read a second time to find the place of an error.
  [[noreturn]] void fail_at_vertex(std::size_t index) const {
    ObjLines lines(text_, file_, most_obj_line);
    for (std::size_t count = 0; auto line = lines.next();) {
      if (line->next() != "v" || count++ != index) continue;
      for (int axis = 0; axis < 3; ++axis) line->require_number();
    }
    PS_ASSERT(false, "the vertex is in the file");
    std::abort();
  }

  /// Names the first of each face.
  [[noreturn]] void fail_at_large_indices() const {
    ObjLines lines(text_, file_, most_obj_line);
    FaultGatherer faults;
    while (auto line = lines.next()) faults.gather([&] { require_known_indices(*line); });
    faults.throw_all();
    PS_ASSERT(false, "the index is in the file");
    std::abort();
  }
  void require_known_indices(ObjLine& line) const {
    const std::string_view statement = line.next();
    if (statement != "f" && statement != "fo") return;
    ObjLine ahead = line;
    if (ahead.next().empty() || ahead.next().empty() || ahead.next().empty()) return;
    for (std::string_view word = line.next(); !word.empty(); word = line.next()) {
      const std::int64_t index = position_index(line, word.substr(0, word.find('/')));
      if (index > static_cast<std::int64_t>(mesh_.positions.size())) fail_index(line, index, mesh_.positions.size());
    }
  }

  /// Replaces the fans that face() made by a triangulation that also holds for polygons that are not convex.
  void cut_polygons() {
    std::vector<Vec3d> points;
    std::vector<MeshTriangle> fan;
    std::int64_t work = most_polygon_work;
    for (const Polygon& polygon : polygons_) {
      MeshTriangle* first = &mesh_.triangles[polygon.first_triangle];
      fan.assign(first, first + polygon.corners - 2);
      const auto corner = [&](std::uint32_t i) -> std::pair<const MeshTriangle&, std::size_t> {
        return i < 2 ? std::pair<const MeshTriangle&, std::size_t>(fan[0], i)
                     : std::pair<const MeshTriangle&, std::size_t>(fan[i - 2], 2);
      };
      points.clear();
      for (std::uint32_t i = 0; i < polygon.corners; ++i)
        points.push_back(mesh_.positions[corner(i).first.position[corner(i).second]]);
      const CutPolygon cut = triangulate_polygon(points, work);
      const auto line = static_cast<int>(mesh_.origins.lines[polygon.first_triangle]);
      if (work <= 0) note("polygons from here on are too many or too large to be cut along their outlines", line);
      if (cut.crosses_itself) note("where the outline of a face crosses itself, its triangles may overlap", line);
      for (std::size_t t = 0; t < cut.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
          const auto& [triangle, place] = corner(cut.triangles[t][k]);
          first[t].position[k] = triangle.position[place];
          first[t].normal[k] = triangle.normal[place];
          first[t].uv[k] = triangle.uv[place];
        }
      }
    }
  }

  /// A triangle has three vertex normals or none; exporters write (0, 0, 0) for degenerate faces, which is none. The
  /// same holds for texture coordinates.
  void drop_unusable_indices() {
    const auto normals = static_cast<std::int32_t>(mesh_.normals.size());
    const auto uvs = static_cast<std::int32_t>(mesh_.uvs.size());
    constexpr std::array<std::int32_t, 3> none{-1, -1, -1};
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      MeshTriangle& triangle = mesh_.triangles[t];
      const FileIndices given{triangle.uv, triangle.normal};
      for (const std::int32_t normal : given.normal) {
        if (normal >= normals) note(no_such_normal, static_cast<int>(mesh_.origins.lines[t]));
        if (normal < 0 || normal >= normals || mesh_.normals[static_cast<std::size_t>(normal)] == Vec3d{0, 0, 0})
          triangle.normal = none;
      }
      for (const std::int32_t uv : given.uv) {
        if (uv >= uvs) note(no_such_uv, static_cast<int>(mesh_.origins.lines[t]));
        if (uv < 0 || uv >= uvs || std::isnan(mesh_.uvs[static_cast<std::size_t>(uv)].x)) triangle.uv = none;
      }
      if (given != FileIndices{triangle.uv, triangle.normal})
        mesh_.origins.unused.push_back({static_cast<std::uint32_t>(t), given});
    }
    for (Vec2d& uv : mesh_.uvs)
      if (std::isnan(uv.x)) uv = {0, 0};
  }

  struct Polygon {
    std::size_t first_triangle, corners;
  };
  std::string_view text_;
  const std::string& file_;
  ObjText result_;
  Mesh& mesh_;
  std::int64_t largest_position_ = -1;
  std::vector<FaceCorner> corners_;
  std::vector<Polygon> polygons_;
  std::optional<std::uint32_t> slot_;
  std::map<std::string, std::uint32_t> slots_, name_ids_;
  std::uint32_t object_ = 0, group_ = 0, smoothing_ = 0;
  std::map<double, std::uint32_t> smoothing_numbers_;
  std::set<std::string> known_files_, unknown_;
  std::vector<std::string_view> noted_;
  std::optional<InputError> first_skipped_;  ///< statement that is not about polygons
};

}  // namespace

ObjText read_obj_text(std::string_view text, const std::string& file) { return ObjReader(text, file).run(); }

}  // namespace ps
