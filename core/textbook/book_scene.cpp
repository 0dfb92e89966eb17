#include "textbook/book_scene.h"

namespace ps {
namespace {

constexpr double levels = 255;

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

}  // namespace ps
