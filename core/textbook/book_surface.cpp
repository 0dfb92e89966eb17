#include <cmath>

#include "textbook/book_scene.h"

// Apart from book_scene(), for programs that get such a scene as bytes (student/runtime).

namespace ps {
namespace {

constexpr double levels_of_white = 255;

/// Eight-bit texels come back as the whole numbers that they were; made ones keep their fractions.
double level(float value) {
  const double exact = static_cast<double>(value) * levels_of_white;
  const double whole = std::round(exact);
  return std::abs(exact - whole) < 1e-4 ? whole : exact;
}

}  // namespace

BookSurface surface_of(const BookScene& scene, const BookInstance& instance, const MeshTriangle& triangle) {
  const std::uint32_t index = instance.instance->material.value_or(instance.model->materials.at(triangle.material));
  const Material& material = scene.scene.materials->at(index);
  const auto picture = [&](int texture) {
    return texture >= 0 ? &scene.scene.textures->at(static_cast<std::size_t>(texture)) : nullptr;
  };
  return {material.colour * levels_of_white, material.specular.value_or(-1), picture(material.texture),
          picture(material.normal_map)};
}

Vec3d texel_of(const Texture& texture, std::size_t index) {
  const Vec3f texel = texture.texels->pixels()[index];
  return {level(texel.x), level(texel.y), level(texel.z)};
}

std::string_view kind_name(const Light& light) { return light_kind_key(light.kind); }

}  // namespace ps
