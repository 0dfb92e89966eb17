#include <cmath>

#include <fmt/format.h>

#include "base/check.h"
#include "math/unit.h"
#include "scene/scene_draft.h"

namespace ps {
namespace {

const std::vector<std::string_view>& form_keys(std::string_view kind) {
  static const std::vector<std::string_view> sphere{"center", "radius"}, plane{"point", "normal"},
      rectangle{"corner", "side_a", "side_b"}, box{"center", "size", "rotation"}, cylinder{"from", "to", "radius"};
  return kind == "sphere"      ? sphere
         : kind == "plane"     ? plane
         : kind == "rectangle" ? rectangle
         : kind == "box"       ? box
                               : cylinder;
}

Form read_form(const SceneSource& source, const SceneFields& fields, std::string_view kind) {
  const SceneValues& values = source.values;
  const auto vec = [&](std::string_view key) { return values.vec3(fields.require(key)); };
  if (kind == "sphere") return Ball{vec("center"), values.positive(fields.require("radius"))};
  if (kind == "plane") return Plane{vec("point"), values.direction(fields.require("normal"))};
  if (kind == "rectangle") {
    const Rectangle rectangle{vec("corner"), values.side(fields.require("side_a")),
                              values.side(fields.require("side_b"))};
    if (!has_right_angle(rectangle)) values.fail(fields.require("side_b"), "a side perpendicular to 'side_a'");
    return rectangle;
  }
  if (kind == "box") {
    Brick brick;
    brick.centre = vec("center");
    brick.size = read_brick_size(values, fields.require("size"));
    if (const auto* term = fields.find("rotation")) brick.rotation = values.frame(*term);
    return brick;
  }
  PS_ASSERT(kind == "cylinder", "a form that the block table knows");
  const Cylinder cylinder{vec("from"), vec("to"), values.positive(fields.require("radius"))};
  if (cylinder.from == cylinder.to) values.fail(fields.require("to"), "a point other than 'from'");
  return cylinder;
}

Solid read_part(const SceneSource& source, const SceneFields& fields, SceneDraft& draft) {
  Solid solid;
  solid.form = read_form(source, fields, fields.block().key);
  solid.material = material_for(source, fields, {}, draft);
  if (const auto* term = fields.find("sides")) solid.sides = read_sides(source.values, *term);
  return solid;
}

bool is_operation(std::string_view key) { return key == "union" || key == "intersection" || key == "difference"; }
bool is_part(std::string_view key) {
  return key == "sphere" || key == "plane" || key == "box" || key == "cylinder" || is_operation(key);
}

class CsgReader {
 public:
  CsgReader(const SceneSource& source, SceneDraft& draft) : source_(source), draft_(draft) {}

  CsgNode node(const SceneEntry& entry) {
    if (is_operation(entry.key)) return combination(entry);
    if (++parts_ > max_csg_parts)
      source_.values.fail_at(entry.line, entry.column, "one part more",
                             fmt::format("at most {} parts in one object", max_csg_parts));
    const SceneFields fields(source_.values, entry,
                             joined_keys(joined_keys({"material"}, form_keys(entry.key)), surface_keys()));
    CsgNode part;
    part.part = read_part(source_, fields, draft_);
    return part;
  }

  CsgNode combination(const SceneEntry& entry) {
    CsgNode node;
    node.operation = entry.key == "union"          ? CsgOperation::union_of
                     : entry.key == "intersection" ? CsgOperation::intersection
                                                   : CsgOperation::difference;
    for (const SceneEntry& child : entry.value.entries) {
      if (child.key == "rectangle")
        source_.values.fail_at(child.line, child.column, "a rectangle", "a solid body: a rectangle has no inside");
      if (is_part(child.key)) node.children.push_back(this->node(child));
    }
    if (node.children.size() < 2)
      source_.values.fail_at(entry.line, entry.column, fmt::format("{} parts", node.children.size()),
                             "two or more of sphere, box, cylinder, plane, union, intersection and difference");
    return node;
  }

 private:
  const SceneSource& source_;
  SceneDraft& draft_;
  std::size_t parts_ = 0;
};

}  // namespace

bool has_right_angle(const Rectangle& rectangle) {
  const Vec3d a = brought_near_one(rectangle.side_a), b = brought_near_one(rectangle.side_b);
  const double product = dot(a, b);
  return product * product <= 1e-12 * dot(a, a) * dot(b, b);
}

Vec3d read_brick_size(const SceneValues& values, const SceneTerm& term) {
  const Vec3d size = term.kind == SceneTerm::Kind::tuple ? values.vec3(term) : Vec3d(values.positive(term));
  if (!(size.x > 0 && size.y > 0 && size.z > 0)) values.fail(term, "lengths above 0");
  return size;
}

void read_solid(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  const SceneFields fields(
      source.values, entry,
      joined_keys(joined_keys({"name", "material", "sides"}, form_keys(entry.key)), surface_keys()));
  add_object(source, fields, {{}, read_part(source, fields, draft)}, draft);
}

void read_csg(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  if (entry.value.kind != SceneTerm::Kind::block) source.values.fail(entry.value, "'{' after the operation");
  Csg csg{CsgReader(source, draft).node(entry)};
  // What is not a part is checked as in any other block: only the name of the whole remains.
  SceneEntry rest = entry;
  std::erase_if(rest.value.entries, [](const SceneEntry& child) { return is_part(child.key); });
  const SceneFields fields(source.values, rest, {"name"});
  add_object(source, fields, {{}, std::move(csg)}, draft);
}

}  // namespace ps
