#include "scene/edit.h"

#include <functional>

#include <fmt/format.h>

#include "base/spelling.h"
#include "scene/form_properties.h"
#include "scene/object_surface.h"
#include "scene/scene_draft.h"
#include "scene/scene_text.h"
#include "scene/scene_value.h"

namespace ps {
namespace {

/// One property: its value as text, and how a parsed value is put in its place.
struct Field {
  std::string path;
  std::string value;
  std::function<void(Scene&, const SceneValues&, const SceneTerm&)> set;
};
using Fields = std::vector<Field>;

Fields camera_fields(const Scene& scene) {
  const Camera& camera = scene.camera;
  Fields fields;
  fields.push_back({"background", scene_colour(scene.background),
                    [](Scene& s, const SceneValues& v, const SceneTerm& t) { s.background = v.colour(t); }});
  fields.push_back({"camera.position", scene_vec(camera.position),
                    [](Scene& s, const SceneValues& v, const SceneTerm& t) { s.camera.position = v.vec3(t); }});
  const auto axis = [&](const char* name, Vec3d Camera::*member) {
    fields.push_back(
        {fmt::format("camera.{}", name), scene_vec(camera.*member),
         [member](Scene& s, const SceneValues& v, const SceneTerm& t) { s.camera.*member = v.camera_axis(t); }});
  };
  axis("right", &Camera::right);
  axis("up", &Camera::up);
  axis("forward", &Camera::forward);
  fields.push_back({"camera.rotation", scene_rotation(Mat3d(camera.right, camera.up, camera.forward)),
                    [](Scene& s, const SceneValues& v, const SceneTerm& t) {
                      const Mat3d rotation = v.frame(t);
                      s.camera.right = rotation[0];
                      s.camera.up = rotation[1];
                      s.camera.forward = rotation[2];
                    }});
  fields.push_back({"camera.viewport_size",
                    scene_number(camera.viewport_width) + " x " + scene_number(camera.viewport_height),
                    [](Scene& s, const SceneValues& v, const SceneTerm& t) {
                      const Vec2d size = v.size(t);
                      s.camera.viewport_width = size.x;
                      s.camera.viewport_height = size.y;
                    }});
  fields.push_back(
      {"camera.projection_plane_d", scene_number(camera.projection_plane_d),
       [](Scene& s, const SceneValues& v, const SceneTerm& t) { s.camera.projection_plane_d = v.positive(t); }});
  return fields;
}

Fields light_fields(const Scene& scene, std::size_t index) {
  const Light& light = scene.lights->at(index);
  Fields fields;
  const auto add = [&](const char* name, std::string value, auto change) {
    fields.push_back({fmt::format("light.{}.{}", index, name), std::move(value),
                      [index, change](Scene& s, const SceneValues& v, const SceneTerm& t) {
                        Light changed = s.lights->at(index);
                        change(changed, v, t);
                        s.lights.edit([&](std::vector<Light>& lights) { lights[index] = changed; });
                      }});
  };
  add("intensity", scene_number(light.intensity),
      [](Light& l, const SceneValues& v, const SceneTerm& t) { l.intensity = v.in_range(t, 0, max_scene_number); });
  add("color", scene_colour(light.colour),
      [](Light& l, const SceneValues& v, const SceneTerm& t) { l.colour = v.colour(t); });
  if (light.kind != LightKind::ambient) {
    add("specular_color", scene_colour(highlight_colour(light)),
        [](Light& l, const SceneValues& v, const SceneTerm& t) {
          l.specular_colour = v.colour(t);
          if (l.specular_colour == l.colour) l.specular_colour.reset();
        });
    add("ambient_color", scene_colour(light.ambient_colour),
        [](Light& l, const SceneValues& v, const SceneTerm& t) { l.ambient_colour = v.colour(t); });
  }
  if (light.kind == LightKind::point)
    add("radius", scene_number(light.radius),
        [](Light& l, const SceneValues& v, const SceneTerm& t) { l.radius = v.in_range(t, 0, max_scene_number); });
  if (light.kind == LightKind::point)
    add("position", scene_vec(light.position),
        [](Light& l, const SceneValues& v, const SceneTerm& t) { l.position = v.vec3(t); });
  if (light.kind == LightKind::point)
    add("attenuation", scene_vec(light.attenuation),
        [](Light& l, const SceneValues& v, const SceneTerm& t) { l.attenuation = read_attenuation(v, t); });
  if (light.kind == LightKind::directional)
    add("direction", scene_vec(light.direction),
        [](Light& l, const SceneValues& v, const SceneTerm& t) { l.direction = v.direction(t); });
  return fields;
}

/// One number or colour of a material.
struct MaterialField {
  const char* name;
  std::string value;
  void (*set)(Material&, const SceneValues&, const SceneTerm&);
};

std::vector<MaterialField> fields_of(const Material& material) {
  std::vector<MaterialField> fields{
      {"color", scene_colour(material.colour),
       [](Material& m, const SceneValues& v, const SceneTerm& t) { m.colour = v.colour(t); }},
      {"specular", scene_number(material.specular.value_or(-1)),
       [](Material& m, const SceneValues& v, const SceneTerm& t) { m.specular = v.specular(t); }},
      {"transparency", scene_number(material.transparency),
       [](Material& m, const SceneValues& v, const SceneTerm& t) { m.transparency = v.in_range(t, 0, 1); }},
      {"refraction_index", scene_number(material.refraction_index),
       [](Material& m, const SceneValues& v, const SceneTerm& t) {
         m.refraction_index = v.in_range(t, min_refraction_index, max_refraction_index);
       }},
      {"reflective", scene_number(material.reflective),
       [](Material& m, const SceneValues& v, const SceneTerm& t) { m.reflective = v.in_range(t, 0, 1); }}};
  if (material.height_map >= 0)
    fields.push_back(
        {"relief_depth", scene_number(material.relief_depth),
         [](Material& m, const SceneValues& v, const SceneTerm& t) { m.relief_depth = v.in_range(t, 0, 1); }});
  return fields;
}

/// The surface of an object, which has it for itself once it is changed.
Fields surface_fields(const Scene& scene, std::size_t index) {
  const bool textured = takes_texture(scene, index), single = has_one_material(scene, index);
  if (!textured && !single) return {};
  const Material& material = object_material(scene, index);
  Fields fields;
  for (MaterialField& field : fields_of(material)) {
    // All of a model with several materials can have one colour, but not one mirror.
    if (!single && std::string_view(field.name) != "color") continue;
    fields.push_back({fmt::format("object.{}.{}", index, field.name), std::move(field.value),
                      [index, set = field.set](Scene& s, const SceneValues& v, const SceneTerm& t) {
                        Material changed = object_material(s, index);
                        set(changed, v, t);
                        edit_object_material(s, index, [&](Material& m) { m = changed; });
                      }});
  }
  if (!textured) return fields;
  fields.push_back({fmt::format("object.{}.texture", index), scene_name(texture_text(scene, material.texture)),
                    [index](Scene& s, const SceneValues& v, const SceneTerm& t) {
                      Scene changed = s;
                      const int texture = find_or_add_texture(changed, v.name(t, "a picture file, or none"));
                      edit_object_material(changed, index, [&](Material& m) { m.texture = texture; });
                      s = std::move(changed);
                    }});
  return fields;
}

/// Shape and place of an object.
Fields shape_fields(const Scene& scene, std::size_t index) {
  const Object& object = scene.geometry->objects.at(index);
  Fields fields;
  const auto add = [&](const char* name, std::string value, auto change) {
    fields.push_back({fmt::format("object.{}.{}", index, name), std::move(value),
                      [index, change](Scene& s, const SceneValues& v, const SceneTerm& t) {
                        Object changed = s.geometry->objects.at(index);
                        change(changed, v, t);
                        s.geometry.edit([&](Geometry& geometry) { geometry.objects[index] = changed; });
                      }});
  };
  if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
    add("center", scene_vec(sphere->centre),
        [](Object& o, const SceneValues& v, const SceneTerm& t) { std::get<Sphere>(o.shape).centre = v.vec3(t); });
    add("radius", scene_number(sphere->radius),
        [](Object& o, const SceneValues& v, const SceneTerm& t) { std::get<Sphere>(o.shape).radius = v.positive(t); });
    return fields;
  }
  if (const auto* solid = std::get_if<Solid>(&object.shape)) {
    for (const FormProperty& property : form_properties(solid->form))
      add(property.name, property.value, [set = property.set](Object& o, const SceneValues& v, const SceneTerm& t) {
        set(std::get<Solid>(o.shape).form, v, t);
      });
    return fields;
  }
  if (const auto* csg = std::get_if<Csg>(&object.shape)) {
    const auto parts = csg_parts(csg->root);
    for (std::size_t k = 0; k < parts.size(); ++k)
      for (const FormProperty& property : form_properties(parts[k]->form)) {
        const std::string name = fmt::format("part.{}.{}", k, property.name);
        add(name.c_str(), property.value, [k, set = property.set](Object& o, const SceneValues& v, const SceneTerm& t) {
          set(csg_parts(std::get<Csg>(o.shape).root)[k]->form, v, t);
        });
      }
    return fields;
  }
  const Transform& transform = std::get<Instance>(object.shape).transform;
  add("scale", scene_vec(transform.scale), [](Object& o, const SceneValues& v, const SceneTerm& t) {
    std::get<Instance>(o.shape).transform.scale = v.scale(t);
  });
  add("rotation", scene_rotation(transform.rotation), [](Object& o, const SceneValues& v, const SceneTerm& t) {
    std::get<Instance>(o.shape).transform.rotation = v.rotation(t);
  });
  add("translation", scene_vec(transform.translation), [](Object& o, const SceneValues& v, const SceneTerm& t) {
    std::get<Instance>(o.shape).transform.translation = v.vec3(t);
  });
  return fields;
}

void append(Fields& all, Fields some) {
  for (Field& field : some) all.push_back(std::move(field));
}

Fields object_fields(const Scene& scene, std::size_t index) {
  Fields fields = shape_fields(scene, index);
  append(fields, surface_fields(scene, index));
  return fields;
}

Fields material_fields(const Scene& scene, std::size_t index) {
  Fields fields;
  for (MaterialField& field : fields_of(scene.materials->at(index)))
    fields.push_back({fmt::format("material.{}.{}", index, field.name), std::move(field.value),
                      [index, set = field.set](Scene& s, const SceneValues& v, const SceneTerm& t) {
                        Material changed = s.materials->at(index);
                        set(changed, v, t);
                        s.materials.edit([&](std::vector<Material>& materials) { materials[index] = changed; });
                      }});
  return fields;
}

/// The fields among which `path` must be, if it exists: those of one object, so that large scenes cost no more.
Fields fields_near(const Scene& scene, std::string_view path) {
  const auto first = path.find('.');
  const auto second = path.find('.', first + 1);
  const std::string_view kind = path.substr(0, first);
  if (first == std::string_view::npos || second == std::string_view::npos) return camera_fields(scene);
  const std::string_view digits = path.substr(first + 1, second - first - 1);
  std::size_t index = 0;
  for (const char c : digits) {
    if (c < '0' || c > '9' || index > 100'000'000) return {};
    index = index * 10 + static_cast<std::size_t>(c - '0');
  }
  if (kind == "light" && index < scene.lights->size()) return light_fields(scene, index);
  if (kind == "object" && index < scene.geometry->objects.size()) return object_fields(scene, index);
  if (kind == "material" && index < scene.materials->size()) return material_fields(scene, index);
  return {};
}

Field find_field(const Scene& scene, std::string_view path) {
  Fields fields = fields_near(scene, path);
  std::vector<std::string_view> known;
  for (Field& field : fields) {
    if (field.path == path) return std::move(field);
    known.push_back(field.path);
  }
  const std::string asked(path.substr(0, 80));
  if (known.empty()) throw InputError(fmt::format("the scene has no property '{}'", asked));
  throw InputError(fmt::format("the scene has no property '{}'{}", asked, did_you_mean(path, known, "")));
}

}  // namespace

std::vector<SceneProperty> scene_properties(const Scene& scene) {
  Fields fields = camera_fields(scene);
  for (std::size_t i = 0; i < scene.lights->size(); ++i) append(fields, light_fields(scene, i));
  for (std::size_t i = 0; i < scene.geometry->objects.size(); ++i) append(fields, object_fields(scene, i));
  for (std::size_t i = 0; i < scene.materials->size(); ++i) append(fields, material_fields(scene, i));
  std::vector<SceneProperty> properties;
  for (Field& field : fields) properties.push_back({std::move(field.path), std::move(field.value)});
  return properties;
}

std::string get_property(const Scene& scene, std::string_view path) { return find_field(scene, path).value; }

void set_property(Scene& scene, std::string_view path, std::string_view value) {
  const Field field = find_field(scene, path);
  const std::string name(path);
  const auto entries = scene_tree(fmt::format("value = {}", value), name);
  if (entries.size() != 1) throw InputError({name, 1, 1}, fmt::format("'{}'", value.substr(0, 80)), "one value");
  field.set(scene, SceneValues(name), entries.front().value);
}

}  // namespace ps
