#pragma once
#include "student/bytes.h"
#include "textbook/book_scene.h"

/// The fields of a scene's parts that listings look at, in their order: a ByteWriter takes them, a ByteReader fills
/// them.

namespace ps {

inline constexpr auto sphere_fields = [](auto& bytes, auto& sphere) {
  bytes.text(sphere.name);
  bytes.value(sphere.centre);
  bytes.value(sphere.radius);
  bytes.value(sphere.colour);
  bytes.value(sphere.specular);
  bytes.value(sphere.reflective);
};

inline constexpr auto model_fields = [](auto& bytes, auto& model) {
  bytes.text(model.name);
  bytes.list(model.positions);
  bytes.list(model.normals);
  bytes.list(model.uvs);
  bytes.list(model.triangles);
  bytes.list(model.materials);
};

inline constexpr auto material_fields = [](auto& bytes, auto& material) {
  bytes.value(material.colour);
  bytes.value(material.specular);
  bytes.value(material.reflective);
  bytes.value(material.specular_colour);
  bytes.value(material.ambient_colour);
  bytes.value(material.transparency);
  bytes.value(material.refraction_index);
  bytes.value(material.texture);
  bytes.value(material.normal_map);
};

}  // namespace ps
