#include "scene/scene_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/input_errors.h"
#include "scene/finish_draft.h"
#include "scene/scene_draft.h"
#include "scene/scene_keys.h"

namespace ps {
namespace {

void read_include(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft);

using ReadBlock = void (*)(const SceneSource&, const SceneEntry&, SceneDraft&);
struct BlockReader {
  std::string_view key;
  ReadBlock read;
  bool once;
};
constexpr std::array<BlockReader, 20> blocks{{{form_key<Ball>, read_sphere, false},
                                              {"light", read_light, false},
                                              {"camera", read_camera, true},
                                              {"material", read_material, false},
                                              {"texture", read_texture, false},
                                              {"model", read_model, false},
                                              {"instance", read_instance, false},
                                              {"group", read_group, false},
                                              {"line", read_line, false},
                                              {"triangle", read_any_triangle, false},
                                              {"polygon", read_any_polygon, false},
                                              {form_key<Plane>, read_solid, false},
                                              {form_key<Rectangle>, read_solid, false},
                                              {form_key<Brick>, read_solid, false},
                                              {form_key<Cylinder>, read_solid, false},
                                              {operation_key(CsgOperation::union_of), read_csg, false},
                                              {operation_key(CsgOperation::intersection), read_csg, false},
                                              {operation_key(CsgOperation::difference), read_csg, false},
                                              {"settings", read_settings, true},
                                              {"include", read_include, false}}};

struct AssignmentReader {
  std::string_view key;
  void (*read)(const SceneValues&, const SceneTerm&, Scene&);
};
constexpr std::array<AssignmentReader, 8> assignments{{
    {"title", [](const SceneValues& v, const SceneTerm& t, Scene& s) { s.title = v.name(t, "a title"); }},
    {"keywords", [](const SceneValues& v, const SceneTerm& t, Scene& s) { s.keywords = v.name(t, "words in quotes"); }},
    {"description",
     [](const SceneValues& v, const SceneTerm& t, Scene& s) { s.description = v.name(t, "a description in quotes"); }},
    {"canvas_size",
     [](const SceneValues& v, const SceneTerm& t, Scene& s) {
       const Vec2d size = v.size(t);
       if (std::floor(size.x) != size.x || std::floor(size.y) != size.y) v.fail(t, "whole numbers of pixels");
       if (size.x > 65536 || size.y > 65536 || size.x * size.y > static_cast<double>(max_image_pixels))
         v.fail(t, fmt::format("at most {} pixels", max_image_pixels));
       s.canvas_width = static_cast<int>(size.x);
       s.canvas_height = static_cast<int>(size.y);
     }},
    {"viewport_size",
     [](const SceneValues& v, const SceneTerm& t, Scene& s) {
       const Vec2d size = v.size(t);
       s.camera.viewport_width = size.x;
       s.camera.viewport_height = size.y;
     }},
    {"projection_plane_d",
     [](const SceneValues& v, const SceneTerm& t, Scene& s) { s.camera.projection_plane_d = v.positive(t); }},
    {"background", [](const SceneValues& v, const SceneTerm& t, Scene& s) { s.background = v.colour(t); }},
    {"start_pixel",
     [](const SceneValues& v, const SceneTerm& t, Scene& s) {
       const bool pair =
           (t.kind == SceneTerm::Kind::tuple || t.kind == SceneTerm::Kind::sequence) && t.items.size() == 2;
       if (!pair) v.fail(t, "a column and a row, such as (312, 204)");
       s.start_pixel = {v.whole(t.items[0], 0, 65535), v.whole(t.items[1], 0, 65535)};
     }},
}};

std::vector<std::string_view> top_level_keys() {
  std::vector<std::string_view> keys;
  keys.reserve(blocks.size() + assignments.size());
  for (const auto& row : blocks) keys.push_back(row.key);
  for (const auto& row : assignments) keys.push_back(row.key);
  return keys;
}

void require_first(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  const auto [earlier, is_new] = draft.single_keys.try_emplace(entry.key, entry.line);
  if (!is_new)
    source.values.fail_at(entry.line, entry.column, fmt::format("a second '{}'", entry.key),
                          fmt::format("the one in line {} only", earlier->second));
}

void read_entry(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  for (const BlockReader& row : blocks) {
    if (row.key != entry.key) continue;
    if (row.once) require_first(source, entry, draft);
    return row.read(source, entry, draft);
  }
  for (const AssignmentReader& row : assignments) {
    if (row.key != entry.key) continue;
    require_first(source, entry, draft);
    return row.read(source.values, entry.value, draft.scene);
  }
  fail_unknown_key(source.values, entry, "a scene", top_level_keys());
}

/// The names that a block would have given, also those inside it.
void note_lost_names(const SceneEntry& entry, SceneDraft& draft) {
  if (entry.key == "name") draft.lost_names.push_back(entry.value.shown());
  for (const SceneEntry& child : entry.value.entries) note_lost_names(child, draft);
}

/// Goes on behind an entry with an error, so that those of other entries are found as well. An entry that only misses
/// what an earlier one failed to define has none of its own. Behind an include too much is missing to go on.
void read_text(std::string_view text, const SceneSource& source, SceneDraft& draft) {
  const std::size_t depth = draft.including.size();
  for (const SceneEntry& entry : scene_tree(text, source.values.file())) {
    try {
      read_entry(source, entry, draft);
    } catch (const InputError& error) {
      if (draft.errors.empty() && dynamic_cast<const InputErrors*>(&error)) throw;  // of an included file or a model
      const auto& lost = draft.lost_names;
      if (std::find(lost.begin(), lost.end(), error.found()) == lost.end()) draft.errors.push_back(error);
      if (entry.key == "include" || draft.errors.size() == most_input_errors)
        throw InputErrors(std::move(draft.errors));
      note_lost_names(entry, draft);
      draft.including.resize(depth);
      draft.group = {};
      draft.group_depth = 0;
    }
  }
}

void read_include(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  constexpr std::size_t deepest = 16;
  constexpr std::size_t most_files = 1000;
  const std::filesystem::path path =
      (source.folder / source.values.name(entry.value, "a file name")).lexically_normal();
  std::error_code ignored;
  const auto canonical = std::filesystem::weakly_canonical(path, ignored);
  for (const auto& outer : draft.including)
    if (outer == canonical) source.values.fail(entry.value, "a file that does not include this one");
  if (draft.including.size() >= deepest)
    source.values.fail(entry.value, fmt::format("at most {} nested files", deepest));
  if (draft.scene.files.size() >= most_files)
    source.values.fail(entry.value, fmt::format("at most {} included files", most_files));
  std::string text;
  try {
    text = read_text_file(path, max_scene_file_bytes);
  } catch (const InputError& error) {
    source.values.fail(entry.value, fmt::format("a file that can be read ({})", error.what()));
  }
  draft.scene.files.push_back(path.string());
  draft.including.push_back(canonical);
  read_text(text, {SceneValues(path.string()), path.parent_path()}, draft);
  draft.including.pop_back();
}

}  // namespace

void read_settings(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  std::vector<std::string_view> keys;
  for (const SceneEntry& setting : entry.value.entries)
    if (!setting.key.empty()) keys.push_back(setting.key);
  const SceneFields fields(source.values, entry, keys);
  const auto place = [&](int line, int column) { return SourcePlace{source.values.file(), line, column}; };
  for (const SceneEntry& setting : entry.value.entries)
    draft.scene.settings.push_back({setting.key, source.values.name(setting.value, "a value"),
                                    place(setting.line, setting.column),
                                    place(setting.value.line, setting.value.column)});
}

Scene parse_scene(std::string_view text, const std::string& file, const std::filesystem::path& folder) {
  SceneDraft draft;
  draft.scene.name = file;
  draft.scene.files = {file};
  std::error_code ignored;
  draft.including.push_back(std::filesystem::weakly_canonical(file, ignored));
  read_text(text, {SceneValues(file), folder}, draft);
  if (!draft.errors.empty()) throw InputErrors(std::move(draft.errors));
  return finish_draft(std::move(draft));
}

SceneHeading parse_scene_heading(std::string_view text, const std::string& file) {
  SceneHeading heading;
  const SceneValues values(file);
  for (const SceneEntry& entry : scene_tree(text, file)) {
    if (entry.key == "title") heading.title = values.name(entry.value);
    if (entry.key == "keywords") heading.keywords = values.name(entry.value);
    if (entry.key == "description") heading.description = values.name(entry.value);
  }
  return heading;
}

}  // namespace ps
