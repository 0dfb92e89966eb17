#include <cmath>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include "base/check.h"
#include "math/unit.h"
#include "scene/form_properties.h"
#include "scene/place_body.h"
#include "scene/scene_draft.h"
#include "scene/scene_keys.h"

namespace ps {
namespace {

/// The keys that a scene file may give this form.
std::vector<std::string_view> property_keys(std::string_view kind) {
  std::vector<std::string_view> keys;
  for (const FormProperty& property : form_properties(*form_named(kind))) keys.emplace_back(property.name);
  return keys;
}

struct FormReader {
  const SceneFields& fields;
  const SceneValues& values;

  Form operator()(Ball ball) const {
    ball.centre = vec("center");
    ball.radius = values.positive(fields.require("radius"));
    return ball;
  }
  Form operator()(const Plane&) const { return Plane{vec("point"), values.direction(fields.require("normal"))}; }
  Form operator()(Rectangle rectangle) const {
    rectangle.corner = vec("corner");
    rectangle.side_a = values.side(fields.require("side_a"));
    rectangle.side_b = values.side(fields.require("side_b"));
    if (!has_right_angle(rectangle)) values.fail(fields.require("side_b"), "a side perpendicular to 'side_a'");
    return rectangle;
  }
  Form operator()(Brick brick) const {
    brick.centre = vec("center");
    brick.size = read_brick_size(values, fields.require("size"));
    if (const auto* term = fields.find("rotation")) brick.rotation = values.frame(*term);
    return brick;
  }
  Form operator()(Cylinder cylinder) const {
    cylinder = {vec("from"), vec("to"), values.positive(fields.require("radius"))};
    if (cylinder.from == cylinder.to) values.fail(fields.require("to"), "a point other than 'from'");
    return cylinder;
  }
  Vec3d vec(std::string_view key) const { return values.vec3(fields.require(key)); }
};

Solid read_part(const SceneSource& source, const SceneFields& fields, SceneDraft& draft) {
  Solid solid;
  solid.form = std::visit(FormReader{fields, source.values}, *form_named(fields.block().key));
  solid.material = material_for(source, fields, {}, draft);
  if (const auto* term = fields.find("sides")) solid.sides = read_sides(source.values, *term);
  return solid;
}

bool is_part(std::string_view key) {
  const auto form = form_named(key);
  return (form && !std::holds_alternative<Rectangle>(*form)) || key == "group" || operation_named(key);
}

class CsgReader {
 public:
  CsgReader(const SceneSource& source, const SceneEntry& root, SceneDraft& draft)
      : source_(source), root_(root), draft_(draft) {}

  /// `around`: the transforms of the groups and operations around the block.
  CsgNode node(const SceneEntry& entry, const PartPlace& around) {
    if (operation_named(entry.key) || entry.key == "group") return combination(entry, around);
    if (++parts_ > max_csg_parts)
      source_.values.fail_at(entry.line, entry.column, "one part more",
                             fmt::format("at most {} parts in one object", max_csg_parts));
    const SceneFields fields(
        source_.values, entry,
        joined_keys(joined_keys({"material", "transform"}, property_keys(entry.key)), surface_keys()));
    CsgNode part;
    part.part = read_part(source_, fields, draft_);
    part.part.place = around.after(read_part_place(source_, fields));
    require_invertible(source_, entry, part.part.place);
    return part;
  }

  /// An operation, or a group, which is the union of its parts and may have a single part.
  CsgNode combination(const SceneEntry& entry, const PartPlace& around) {
    if (entry.value.kind != SceneTerm::Kind::block)
      source_.values.fail(entry.value, fmt::format("'{{' after '{}'", entry.key));
    const bool is_group = entry.key == "group";
    CsgNode node;
    node.operation = operation_named(entry.key).value_or(CsgOperation::union_of);
    for (const SceneEntry& child : entry.value.entries) {
      if (child.key == form_key<Rectangle>)
        source_.values.fail_at(child.line, child.column, "a rectangle", "a solid body: a rectangle has no inside");
      if (child.key == "instance")
        source_.values.fail_at(child.line, child.column, fmt::format("an instance inside '{}'", entry.key),
                               "a solid body: a model of triangles may have no inside");
    }
    const PartPlace place = around.after(place_of(entry));
    for (const SceneEntry& child : entry.value.entries)
      if (is_part(child.key)) node.children.push_back(this->node(child, place));
    const std::size_t least = is_group ? 1 : 2;
    if (node.children.size() < least)
      source_.values.fail_at(
          entry.line, entry.column, fmt::format("'{}' with {} parts", entry.key, node.children.size()),
          fmt::format("{} or more of sphere, box, cylinder, plane, group, union, intersection and difference",
                      is_group ? "one" : "two"));
    if (is_group && node.children.size() == 1) return std::move(node.children.front());
    return node;
  }

 private:
  /// All but parts is checked as in any other block.
  PartPlace place_of(const SceneEntry& entry) const {
    SceneEntry own = entry;
    std::erase_if(own.value.entries, [](const SceneEntry& child) { return is_part(child.key); });
    const SceneFields fields(source_.values, own, {"name", "dynamic", "position", "transform"});
    if (&entry != &root_) fields.forbid({"name", "dynamic"}, "a name and a mark of the whole object alone");
    return read_part_place(source_, fields);
  }

  const SceneSource& source_;
  const SceneEntry& root_;
  SceneDraft& draft_;
  std::size_t parts_ = 0;
};

}  // namespace

void require_invertible(const SceneSource& source, const SceneEntry& entry, const PartPlace& place) {
  constexpr double largest = 1e9;
  double reach = 0;
  const Mat3d back = inverse(place.linear);
  for (int axis = 0; axis < 3; ++axis)
    for (const Vec3d& v : {place.linear[axis], back[axis]})
      for (int i = 0; i < 3; ++i) reach = std::abs(v[i]) <= largest ? std::max(reach, std::abs(v[i])) : largest * 2;
  if (!(reach <= largest))
    source.values.fail_at(entry.line, entry.column, "transforms whose product is too large, too small or flat",
                          fmt::format("scales from {:g} to {:g} in all", 1 / largest, largest));
}

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
      joined_keys(joined_keys({"name", "dynamic", "material", "sides"}, property_keys(entry.key)), surface_keys()));
  const Solid solid = read_part(source, fields, draft);
  require_invertible(source, entry, draft.group);
  add_object(source, fields, {{}, placed_body(solid, draft.group, draft.materials[solid.material])}, draft);
}

void read_csg(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  if (entry.value.kind != SceneTerm::Kind::block) source.values.fail(entry.value, "'{' after the operation");
  Csg csg{CsgReader(source, entry, draft).node(entry, draft.group)};
  SceneEntry rest = entry;
  std::erase_if(rest.value.entries, [](const SceneEntry& child) { return is_part(child.key); });
  const SceneFields fields(source.values, rest, {"name", "dynamic", "position", "transform"});
  add_object(source, fields, {{}, std::move(csg)}, draft);
}

}  // namespace ps
