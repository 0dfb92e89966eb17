#include <fmt/format.h>

#include <cmath>

#include "base/enumerators.h"
#include "base/spelling.h"
#include "scene/place_body.h"
#include "scene/scene_draft.h"
#include "scene/scene_keys.h"

namespace ps {
void add_object(const SceneSource& source, const SceneFields& fields, Object object, SceneDraft& draft) {
  if (const SceneTerm* name = fields.find("name")) {
    object.name = source.values.name(*name);
    const auto [earlier, is_new] = draft.object_lines.try_emplace(object.name, name->line);
    if (!is_new) source.values.fail(*name, fmt::format("a name other than that in line {}", earlier->second));
  }
  if (const SceneTerm* dynamic = fields.find("dynamic")) object.dynamic = source.values.on_off(*dynamic);
  draft.geometry.objects.push_back(std::move(object));
  if (draft.geometry.objects.size() > max_scene_objects)
    source.values.fail_at(fields.block().line, fields.block().column, fmt::format("'{}'", fields.block().key),
                          fmt::format("at most {} spheres and instances", max_scene_objects));
}

Sides read_sides(const SceneValues& values, const SceneTerm& term) {
  constexpr const char* expected = "two or front";
  if (const auto sides = enumerator_named<Sides>(values.name(term, expected))) return *sides;
  values.fail(term, expected);
}

namespace {

Transform read_transform(const SceneSource& source, const SceneFields& instance) {
  const SceneValues& values = source.values;
  Transform transform;
  const SceneTerm* block = instance.find("transform");
  if (block == nullptr) {
    if (const auto* term = instance.find("position")) transform.translation = values.vec3(*term);
    return transform;
  }
  instance.forbid({"position"}, "no 'position' beside 'transform', which has a 'translation'");
  const SceneEntry entry{"transform", *block, block->line, block->column};
  const SceneFields fields(values, entry, {"scale", "rotation", "translation"});
  if (const auto* term = fields.find("scale")) transform.scale = values.scale(*term);
  if (const auto* term = fields.find("rotation")) transform.rotation = values.rotation(*term);
  if (const auto* term = fields.find("translation")) transform.translation = values.vec3(*term);
  return transform;
}

/// The transform as one map.
PartPlace as_place(const Transform& transform) {
  const Mat3d& r = transform.rotation;
  const Vec3d& scale = transform.scale;
  return {Mat3d(r[0] * scale.x, r[1] * scale.y, r[2] * scale.z), transform.translation};
}

/// An instance's own transform, seen from outside the group. A map of the group that is more than a translation goes
/// into `rotation` whole, with the instance's scale: together they may shear.
Transform seen_from_outside(const PartPlace& group, const Transform& inner) {
  Transform outer = inner;
  outer.translation = group.linear * inner.translation + group.translation;
  if (group.linear == Mat3d(1.0)) return outer;
  outer.rotation = group.linear * as_place(inner).linear;
  outer.scale = {1, 1, 1};
  return outer;
}

/// The transform in the groups around the block. Factors multiply, so even numbers that are allowed one by one may end
/// beyond all bounds.
Transform placed(const SceneSource& source, const SceneEntry& entry, const SceneFields& fields,
                 const SceneDraft& draft) {
  constexpr double largest = 1e18;
  const Transform transform = seen_from_outside(draft.group, read_transform(source, fields));
  const Mat3d& r = transform.rotation;
  for (const Vec3d& v : {r[0], r[1], r[2], transform.translation})
    for (int axis = 0; axis < 3; ++axis)
      if (!(std::abs(v[axis]) <= largest))
        source.values.fail_at(entry.line, entry.column, "transforms whose product is too large",
                              fmt::format("numbers up to {:g}", largest));
  return transform;
}

}  // namespace

PartPlace read_part_place(const SceneSource& source, const SceneFields& fields) {
  return as_place(read_transform(source, fields));
}

namespace {

/// The surface keys of an instance change its model's material; a model with several must be given one whole.
Material base_material(const SceneSource& source, const SceneFields& fields, const Mesh& mesh,
                       const SceneDraft& draft) {
  if (mesh.materials.size() == 1) {
    Material base = draft.materials[mesh.materials.front()];
    base.name.clear();
    return base;
  }
  if (fields.find("color") == nullptr && fields.find("texture") == nullptr)
    source.values.fail_at(
        fields.block().line, fields.block().column, "an instance that changes its surface",
        fmt::format("'color' or 'texture' too, since '{}' has {} materials", mesh.name, mesh.materials.size()));
  return {};
}

}  // namespace

void read_sphere(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  const SceneFields fields(source.values, entry,
                           joined_keys({"name", "dynamic", "center", "radius", "material"}, surface_keys()));
  Sphere sphere;
  sphere.centre = source.values.vec3(fields.require("center"));
  sphere.radius = source.values.positive(fields.require("radius"));
  sphere.material = material_for(source, fields, {}, draft);
  require_invertible(source, entry, draft.group);
  const Solid body{Ball{sphere.centre, sphere.radius}, sphere.material};
  add_object(source, fields, {{}, placed_body(body, draft.group, draft.materials[sphere.material])}, draft);
}

void read_instance(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  const SceneFields fields(
      source.values, entry,
      joined_keys({"name", "dynamic", "model", "position", "transform", "material", "sides"}, surface_keys()));
  const SceneTerm& model = fields.require("model");
  const auto mesh = draft.mesh_index.find(source.values.name(model, "the name of a model"));
  if (mesh == draft.mesh_index.end()) {
    std::vector<std::string_view> known;
    for (const auto& [name, index] : draft.mesh_index) known.push_back(name);
    source.values.fail(model, known.empty() ? "a model defined before this line"
                                            : fmt::format("a model defined before this line, such as '{}'",
                                                          nearest_word(model.text, known)));
  }
  Instance instance;
  instance.mesh = mesh->second;
  charge_triangles(source, entry, draft.geometry.meshes[instance.mesh]->triangles.size(), draft);
  instance.transform = placed(source, entry, fields, draft);
  if (const auto* term = fields.find("sides")) instance.sides = read_sides(source.values, *term);
  if (fields.find("material") != nullptr) {
    instance.material = material_for(source, fields, {}, draft);
  } else if (has_surface(fields)) {
    const Mesh& shape = *draft.geometry.meshes[instance.mesh];
    instance.material = material_for(source, fields, base_material(source, fields, shape, draft), draft);
  }
  add_object(source, fields, {{}, instance}, draft);
}

namespace {

using ReadBlock = void (*)(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft);

/// The function that reads a member of a group; nullptr for a member that a group cannot have.
ReadBlock member_reader(std::string_view key) {
  if (key == "group") return read_group;
  if (key == "instance") return read_instance;
  if (key == form_key<Ball>) return read_sphere;
  if (const auto form = form_named(key); form && !is_flat(*form)) return read_solid;
  if (operation_named(key)) return read_csg;
  return nullptr;
}

}  // namespace

void read_group(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  constexpr int deepest = 16;
  if (entry.value.kind != SceneTerm::Kind::block) source.values.fail(entry.value, "'{' after 'group'");
  if (draft.group_depth >= deepest)
    source.values.fail_at(entry.line, entry.column, "a group", fmt::format("at most {} nested groups", deepest));
  for (const SceneEntry& child : entry.value.entries)
    for (const std::string_view solid : {form_key<Plane>, form_key<Rectangle>})
      if (child.key == solid)
        source.values.fail_at(child.line, child.column, fmt::format("'{}' inside 'group'", solid),
                              "sphere, box, cylinder, instance, group, union, intersection or difference");
  SceneEntry own = entry;
  std::erase_if(own.value.entries, [](const SceneEntry& child) { return member_reader(child.key) != nullptr; });
  const SceneFields fields(source.values, own, {"position", "transform"});
  const PartPlace around = draft.group;
  draft.group = as_place(placed(source, entry, fields, draft));
  ++draft.group_depth;
  for (const SceneEntry& child : entry.value.entries)
    if (const ReadBlock read = member_reader(child.key)) read(source, child, draft);
  --draft.group_depth;
  draft.group = around;
}

}  // namespace ps
