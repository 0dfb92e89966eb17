#include "textbook/book_scene.h"

#include <cmath>

namespace ps {
namespace {

constexpr double levels = 255;

/// Eight-bit texels come back as the whole numbers that they were; made ones keep their fractions.
double level(float value) {
  const double exact = static_cast<double>(value) * levels;
  const double whole = std::round(exact);
  return std::abs(exact - whole) < 1e-4 ? whole : exact;
}

}  // namespace

BookScene book_scene(const Scene& scene, const View& view, const Settings& settings) {
  BookScene book{scene, settings, view.camera,   view.width, view.height, scene.background * levels,
                 {},    {},       *scene.lights, {}};
  // The height is kept and the width follows, as viewport-fit = height does.
  book.camera.viewport_width = book.camera.viewport_height * view.width / view.height;
  for (const Object& object : scene.geometry->objects) {
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
      const Material& material = scene.materials->at(sphere->material);
      book.spheres.push_back({object.name, sphere->centre, sphere->radius, material.colour * levels,
                              material.specular.value_or(-1), material.reflective});
    } else if (const auto* instance = std::get_if<Instance>(&object.shape)) {
      const Mesh& mesh = *scene.geometry->meshes.at(instance->mesh);
      book.instances.push_back({object.name, &mesh, instance, nullptr});
      if (auto plain = unmirrored(mesh, *instance)) {
        const auto& kept = book.unmirrored.emplace_back(std::make_shared<const Unmirrored>(std::move(*plain)));
        book.instances.back().model = &kept->mesh;
        book.instances.back().instance = &kept->instance;
      }
    }
  }
  return book;
}

BookSurface surface_of(const BookScene& scene, const BookInstance& instance, const MeshTriangle& triangle) {
  const std::uint32_t index = instance.instance->material.value_or(instance.model->materials.at(triangle.material));
  const Material& material = scene.scene.materials->at(index);
  BookSurface surface{material.colour * levels, material.specular.value_or(-1), nullptr};
  if (material.texture >= 0) surface.texture = &scene.scene.textures->at(static_cast<std::size_t>(material.texture));
  return surface;
}

Vec3d texel_of(const Texture& texture, std::size_t index) {
  const Vec3f texel = texture.texels->pixels()[index];
  return {level(texel.x), level(texel.y), level(texel.z)};
}

std::string_view kind_name(const Light& light) { return light_kind_key(light.kind); }

}  // namespace ps
