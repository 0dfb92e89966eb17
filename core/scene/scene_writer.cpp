#include "scene/scene_writer.h"

#include <cmath>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/check.h"
#include "scene/form_properties.h"
#include "scene/free_names.h"
#include "scene/rotation.h"
#include "scene/scene_keys.h"
#include "scene/scene_text.h"
#include "scene/texture_generator.h"

namespace ps {
namespace {

namespace fs = std::filesystem;

/// Unique names, also for what has none.
template <class Things, class NameOf>
std::vector<std::string> unique_names(const Things& things, const std::string& otherwise, NameOf name_of) {
  FreeNames free;
  std::vector<std::string> names;
  names.reserve(things.size());
  for (const auto& thing : things) names.push_back(free.claim(name_of(thing).empty() ? otherwise : name_of(thing)));
  return names;
}

/// The divisions of a teapot with this number of triangles: 64 n^2 - 8 n (scene/generate/teapot.h).
int teapot_divisions(double triangles) {
  return static_cast<int>(std::lround((8 + std::sqrt(64 + 256 * triangles)) / 128));
}

/// A form's own lines.
std::string form_lines(const Form& form, const std::string& indent) {
  std::string text;
  for (const FormProperty& property : form_properties(form))
    if (!property.usual) text += fmt::format("{}{} = {}\n", indent, property.name, property.value);
  return text;
}

class SceneWriter {
 public:
  SceneWriter(const Scene& scene, const fs::path& folder) : scene_(scene), folder_(folder) {
    materials_ = unique_names(*scene.materials, "material", [](const Material& m) { return m.name; });
    textures_ = unique_names(*scene.textures, "texture", [](const Texture& t) { return t.name; });
    meshes_ = unique_names(scene.geometry->meshes, "model", [](const auto& m) { return m->name; });
    objects_ = unique_names(scene.geometry->objects, "object", [](const Object& o) { return o.name; });
    count_uses();
  }

  std::string run() {
    heading();
    camera();
    for (std::size_t i = 0; i < scene_.textures->size(); ++i) texture(i);
    for (std::size_t i = 0; i < scene_.geometry->meshes.size(); ++i) model(i);
    for (std::size_t i = 0; i < scene_.geometry->objects.size(); ++i) object(i);
    materials_up_to(scene_.materials->size());
    for (const Light& one : *scene_.lights) light(one);
    for (const CanvasItem& item : *scene_.canvas_items)
      std::visit([&](const auto& shape) { canvas_item(shape); }, item);
    return std::move(text_);
  }

 private:
  template <class... Values>
  void line(fmt::format_string<const Values&...> form, const Values&... values) {
    text_ += fmt::format(form, values...);
    text_ += '\n';
  }

  void heading() {
    if (scene_.title != scene_.name) line("title = {}", scene_name(scene_.title));
    if (!scene_.description.empty()) line("description = {}", scene_name(scene_.description));
    if (!scene_.keywords.empty()) line("keywords = {}", scene_name(scene_.keywords));
    line("canvas_size = {} x {}", scene_.canvas_width, scene_.canvas_height);
    line("viewport_size = {} x {}", scene_number(scene_.camera.viewport_width),
         scene_number(scene_.camera.viewport_height));
    line("projection_plane_d = {}", scene_number(scene_.camera.projection_plane_d));
    line("background = {}", scene_colour(scene_.background));
    if (scene_.start_pixel.x >= 0 && scene_.start_pixel.y >= 0)
      line("start_pixel = ({}, {})", scene_.start_pixel.x, scene_.start_pixel.y);
    if (scene_.settings.empty()) return;
    line("\nsettings {{");
    for (const SceneSetting& setting : scene_.settings) line("    {} = {}", setting.key, setting.value);
    line("}}");
  }

  void camera() {
    const Camera& camera = scene_.camera;
    const Mat3d frame(camera.right, camera.up, camera.forward);
    const bool turned = frame != Mat3d(1.0);
    if (!turned && camera.position == Vec3d{0, 0, 0}) return;
    line("\ncamera {{");
    line("    position = {}", scene_vec(camera.position));
    if (turned && axis_angle_of(frame)) {
      line("    rotation = {}", scene_rotation(frame));
    } else if (turned) {
      line("    right = {}", scene_vec(camera.right));
      line("    up = {}", scene_vec(camera.up));
      line("    forward = {}", scene_vec(camera.forward));
    }
    line("}}");
  }

  std::string file_name(const std::string& path) const {
    std::error_code error;
    const fs::path relative = fs::proximate(path, folder_.empty() ? fs::path(".") : folder_, error);
    return scene_name((error ? fs::path(path) : relative).generic_string());
  }

  void texture(std::size_t index) {
    const Texture& texture = scene_.textures->at(index);
    line("\ntexture {{\n    name = {}", scene_name(textures_[index]));
    if (!texture.faces.empty()) {
      std::string faces;
      for (const std::string& face : texture.faces)
        faces += fmt::format("{}{}", faces.empty() ? "" : ", ", face.empty() ? "none" : file_name(face));
      line("    cube = [{}]", faces);
    } else if (!texture.path.empty()) {
      line("    file = {}", file_name(texture.path));
      if (texture.channel != TextureChannel::colour) line("    channel = {}", texture_channel_name(texture.channel));
      if (const auto steepness = heights_steepness(texture.generator))
        line("    heights = {}", scene_number(*steepness));
    } else if (!texture.generator.empty()) {
      line("    generator = {}\n    size = {}", texture.generator, texture.texels->width());
    } else {
      throw InputError(fmt::format("the texture '{}' exists only in memory and cannot be saved", texture.name));
    }
    if (texture.base != 0 || texture.gain != 1)
      line("    levels = ({}, {})", scene_number(texture.base), scene_number(texture.gain));
    if (texture.clamped) line("    clamp = on");
    line("}}");
  }

  void count_uses() {
    uses_.assign(scene_.materials->size(), 0);
    for (const auto& mesh : scene_.geometry->meshes)
      for (const std::uint32_t slot : mesh->materials) uses_.at(slot) += 2;
    for (const Object& object : scene_.geometry->objects) {
      if (const auto* sphere = std::get_if<Sphere>(&object.shape)) uses_.at(sphere->material) += 1;
      if (const auto* solid = std::get_if<Solid>(&object.shape)) uses_.at(solid->material) += 2;
      if (const auto* csg = std::get_if<Csg>(&object.shape))
        for (const Solid* part : csg_parts(csg->root)) uses_.at(part->material) += 2;
      if (const auto* instance = std::get_if<Instance>(&object.shape); instance != nullptr && instance->material)
        uses_.at(*instance->material) += 2;
    }
  }

  /// Materials are in the file in the order of their indices; a sphere's own is in the sphere, as in the book.
  void materials_up_to(std::size_t end) {
    for (; next_material_ < end; ++next_material_) {
      line("\nmaterial {{\n    name = {}", scene_name(materials_[next_material_]));
      surface(scene_.materials->at(next_material_));
      line("}}");
    }
  }

  void map(std::string_view key, int texture) {
    if (texture >= 0) line("    {} = {}", key, scene_name(textures_.at(static_cast<std::size_t>(texture))));
  }

  void surface(const Material& material) {
    line("    color = {}", scene_colour(material.colour));
    if (material.specular) line("    specular = {}", scene_number(*material.specular));
    if (material.reflective != 0) line("    reflective = {}", scene_number(material.reflective));
    map("texture", material.texture);
    map("normal_map", material.normal_map);
    map("height_map", material.height_map);
    map("specular_map", material.specular_map);
    map("ambient_map", material.ambient_map);
    map("opacity_map", material.opacity_map);
    map("reflection_map", material.reflection_map);
    if (material.surroundings == Surroundings::cube) line("    surroundings = cube");
    if (material.relief_depth != Material().relief_depth)
      line("    relief_depth = {}", scene_number(material.relief_depth));
    if (material.specular_colour) line("    specular_color = {}", scene_colour(*material.specular_colour));
    if (material.ambient_colour) line("    ambient_color = {}", scene_colour(*material.ambient_colour));
    if (material.transparency != 0) line("    transparency = {}", scene_number(material.transparency));
    if (material.refraction_index != 1) line("    refraction_index = {}", scene_number(material.refraction_index));
  }

  void model(std::size_t index) {
    const Mesh& mesh = *scene_.geometry->meshes[index];
    for (const std::uint32_t slot : mesh.materials) materials_up_to(slot + std::size_t{1});
    line("\nmodel {{\n    name = {}", scene_name(meshes_[index]));
    if (!mesh.patches.empty()) {  // only the teapot has them
      const auto triangles = static_cast<double>(mesh.triangles.size());
      line("    generator = teapot\n    divisions = {}\n    material = {}\n}}", teapot_divisions(triangles),
           scene_name(materials_[mesh.materials.front()]));
      return;
    }
    std::string slots;
    for (const std::uint32_t slot : mesh.materials)
      slots += fmt::format("{}{}", slots.empty() ? "" : ", ", scene_name(materials_[slot]));
    line("    materials = [{}]", slots);
    if (!mesh.source.empty()) {
      line("    file = {}", file_name(mesh.source));
    } else {
      list("vertices", mesh.positions);
      if (!mesh.normals.empty()) list("normals", mesh.normals);
      if (!mesh.uvs.empty()) list("uvs", mesh.uvs);
      line("    triangles {{");
      for (std::size_t i = 0; i < mesh.triangles.size(); ++i) triangle(mesh, i);
      line("    }}");
    }
    line("}}");
  }

  template <class Vec>
  void list(std::string_view name, const std::vector<Vec>& values) {
    line("    {} {{", name);
    for (std::size_t i = 0; i < values.size(); ++i) line("        {} = {}", i, scene_vec(values[i]));
    line("    }}");
  }

  void triangle(const Mesh& mesh, std::size_t index) {
    const MeshTriangle& triangle = mesh.triangles[index];
    const auto& p = triangle.position;
    const bool plain = triangle.normal[0] < 0 && triangle.uv[0] < 0 && triangle.material == 0;
    if (plain) return line("        {} = {}, {}, {}", index, p[0], p[1], p[2]);
    std::string parts = fmt::format("vertices = [{}, {}, {}]", p[0], p[1], p[2]);
    const auto add = [&](std::string_view name, const std::array<std::int32_t, 3>& corners) {
      if (corners[0] >= 0) parts += fmt::format("  {} = [{}, {}, {}]", name, corners[0], corners[1], corners[2]);
    };
    add("normals", triangle.normal);
    add("uvs", triangle.uv);
    if (triangle.material != 0)
      parts += fmt::format("  material = {}", scene_name(materials_[mesh.materials.at(triangle.material)]));
    line("        {} = {{ {} }}", index, parts);
  }

  void object(std::size_t index) {
    const Object& object = scene_.geometry->objects[index];
    if (const auto* shape = std::get_if<Sphere>(&object.shape)) return sphere(index, *shape);
    if (const auto* shape = std::get_if<Solid>(&object.shape)) return solid(index, *shape);
    if (const auto* shape = std::get_if<Csg>(&object.shape)) return csg(index, *shape);
    const auto& instance = std::get<Instance>(object.shape);
    if (instance.material) materials_up_to(*instance.material + std::size_t{1});
    line("\ninstance {{\n    name = {}\n    model = {}", scene_name(objects_[index]),
         scene_name(meshes_[instance.mesh]));
    mark(object, "    ");
    if (instance.material) line("    material = {}", scene_name(materials_[*instance.material]));
    if (instance.sides == Sides::front) line("    sides = {}", enumerator_key(instance.sides));
    const Transform& transform = instance.transform;
    const bool turned = transform.rotation != Mat3d(1.0);
    if (!turned && transform.scale == Vec3d{1, 1, 1}) {
      line("    position = {}\n}}", scene_vec(transform.translation));
      return;
    }
    line("    transform {{");
    const Vec3d& scale = transform.scale;
    if (scale != Vec3d{1, 1, 1})
      line("        scale = {}", scale == Vec3d(scale.x) ? scene_number(scale.x) : scene_vec(scale));
    if (turned) line("        rotation = {}", scene_rotation(transform.rotation));
    line("        translation = {}\n    }}\n}}", scene_vec(transform.translation));
  }

  void mark(const Object& object, const std::string& indent) {
    if (object.dynamic) line("{}dynamic = on", indent);
  }

  void sphere(std::size_t index, const Sphere& sphere) {
    const bool own = sphere.material == next_material_ && uses_[sphere.material] == 1 &&
                     materials_[sphere.material] == objects_[index];
    if (!own) materials_up_to(sphere.material + std::size_t{1});
    line("\nsphere {{\n    name = {}\n    center = {}\n    radius = {}", scene_name(objects_[index]),
         scene_vec(sphere.centre), scene_number(sphere.radius));
    mark(scene_.geometry->objects[index], "    ");
    if (own) {
      surface(scene_.materials->at(next_material_++));
    } else {
      line("    material = {}", scene_name(materials_[sphere.material]));
    }
    line("}}");
  }

  void solid(std::size_t index, const Solid& solid) {
    materials_up_to(solid.material + std::size_t{1});
    const bool in_group = !solid.place.is_identity();
    const std::string indent = in_group ? "    " : "";
    text_ += '\n';
    if (in_group) {
      line("group {{");
      place(solid.place, indent);
    }
    line("{0}{1} {{\n{0}    name = {2}", indent, form_name(solid.form), scene_name(objects_[index]));
    mark(scene_.geometry->objects[index], indent + "    ");
    text_ += form_lines(solid.form, indent + "    ");
    line("{}    material = {}", indent, scene_name(materials_[solid.material]));
    if (solid.sides == Sides::front) line("{}    sides = {}", indent, enumerator_key(solid.sides));
    line("{}}}", indent);
    if (in_group) line("}}");
  }

  void place(const PartPlace& place, const std::string& indent) {
    line("{0}transform {{\n{0}    rotation = {1}\n{0}    translation = {2}\n{0}}}", indent,
         scene_rotation(place.linear), scene_vec(place.translation));
  }

  void csg(std::size_t index, const Csg& csg) {
    for (const Solid* part : csg_parts(csg.root)) materials_up_to(part->material + std::size_t{1});
    line("\n{} {{\n    name = {}", operation_name(csg.root.operation), scene_name(objects_[index]));
    mark(scene_.geometry->objects[index], "    ");
    for (const CsgNode& child : csg.root.children) csg_node(child, "    ");
    line("}}");
  }

  void csg_node(const CsgNode& node, const std::string& indent) {
    const bool part = node.children.empty();
    line("{}{} {{", indent, part ? form_name(node.part.form) : operation_name(node.operation));
    for (const CsgNode& child : node.children) csg_node(child, indent + "    ");
    if (part) {
      text_ += form_lines(node.part.form, indent + "    ");
      if (!node.part.place.is_identity()) place(node.part.place, indent + "    ");
      line("{}    material = {}", indent, scene_name(materials_[node.part.material]));
    }
    line("{}}}", indent);
  }

  void light(const Light& light) {
    line("\nlight {{");
    switch (light.kind) {
    case LightKind::ambient:
      line("    type = ambient");
      break;
    case LightKind::point:
      line("    type = point\n    position = {}", scene_vec(light.position));
      break;
    case LightKind::directional:
      line("    type = directional\n    direction = {}", scene_vec(light.direction));
      break;
    }
    line("    intensity = {}", scene_number(light.intensity));
    if (light.colour != Vec3d{1, 1, 1}) line("    color = {}", scene_colour(light.colour));
    if (light.specular_colour) line("    specular_color = {}", scene_colour(*light.specular_colour));
    if (light.ambient_colour != Vec3d{0, 0, 0}) line("    ambient_color = {}", scene_colour(light.ambient_colour));
    if (light.attenuation != Vec3d{1, 0, 0}) line("    attenuation = {}", scene_vec(light.attenuation));
    if (light.radius > 0) line("    radius = {}", scene_number(light.radius));
    line("}}");
  }

  void blend(Blend blend) {
    if (blend != Blend::replace) line("    blend = {}", enumerator_key(blend));
  }

  void canvas_item(const CanvasLine& item) {
    line("\nline {{\n    from = {}\n    to = {}", scene_vec(item.points[0]), scene_vec(item.points[1]));
    line("    color = {}", scene_colour(item.colour));
    blend(item.blend);
    line("}}");
  }

  void canvas_item(const CanvasPolygon& item) {
    const auto each = [&](auto&& text_of) {
      std::string all;
      for (const CanvasVertex& vertex : item.vertices) all += (all.empty() ? "" : ", ") + text_of(vertex);
      return all;
    };
    line("\npolygon {{\n    vertices = [{}]", each([](const CanvasVertex& v) { return scene_vec(v.point); }));
    line("    colors = [{}]", each([](const CanvasVertex& v) { return scene_colour(v.colour); }));
    line("    h = [{}]", each([](const CanvasVertex& v) { return scene_number(v.h); }));
    if (!item.filled) line("    filled = off");
    if (item.outline) line("    outline = {}", scene_colour(*item.outline));
    blend(item.blend);
    line("}}");
  }

  void canvas_item(const CanvasTriangle& item) {
    line("\ntriangle {{\n    vertices = [{}, {}, {}]", scene_vec(item.points[0]), scene_vec(item.points[1]),
         scene_vec(item.points[2]));
    line("    colors = [{}, {}, {}]", scene_colour(item.colours[0]), scene_colour(item.colours[1]),
         scene_colour(item.colours[2]));
    line("    h = [{}, {}, {}]", scene_number(item.h[0]), scene_number(item.h[1]), scene_number(item.h[2]));
    if (!item.filled) line("    filled = off");
    if (item.outline) line("    outline = {}", scene_colour(*item.outline));
    blend(item.blend);
    line("}}");
  }

  const Scene& scene_;
  const fs::path& folder_;
  std::vector<std::string> materials_, textures_, meshes_, objects_;
  std::vector<int> uses_;  ///< 1 = one sphere alone
  std::size_t next_material_ = 0;
  std::string text_;
};

}  // namespace

std::string write_scene(const Scene& scene, const fs::path& folder) { return SceneWriter(scene, folder).run(); }

void save_scene(const Scene& scene, const fs::path& path) {
  write_file_atomically(path, write_scene(scene, path.parent_path()));
}

}  // namespace ps
