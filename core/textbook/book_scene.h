#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "frame/view.h"
#include "options/settings.h"
#include "scene/scene.h"
#include "textbook/unmirrored.h"

/// A scene as the listings see it: the book's words, colours from 0 to 255, everything in double.

namespace ps {

struct BookSphere {
  std::string name;
  Vec3d centre{0, 0, 0};
  double radius = 1;
  Vec3d colour{0, 0, 0};  ///< 0 to 255
  double specular = -1;   ///< exponent of the highlight; -1 = matte
  double reflective = 0;
};

/// A model with its place in the world: scale, then rotation, then translation.
struct BookInstance {
  std::string name;
  const Mesh* model = nullptr;
  const Instance* instance = nullptr;
  const std::vector<std::uint32_t>* numbers =
      nullptr;  ///< where `model` is a part: index of its triangles in the whole

  /// Where a triangle of `model` is in the whole model.
  std::int64_t number_of(const MeshTriangle& triangle) const {
    const std::ptrdiff_t index = &triangle - model->triangles.data();
    return numbers ? std::int64_t{(*numbers)[static_cast<std::size_t>(index)]} : index;
  }
};

/// The material of a triangle's surface.
struct BookSurface {
  Vec3d colour{0, 0, 0};  ///< 0 to 255
  double specular = -1;
  const Texture* texture = nullptr;     ///< nullptr = none
  const Texture* normal_map = nullptr;  ///< nullptr = none
};

struct BookScene {
  const Scene& scene;
  const Settings& settings;
  Camera camera;  ///< with the viewport as wide as the picture asks
  int width = 0, height = 0;
  Vec3d background{255, 255, 255};
  std::vector<BookSphere> spheres;
  std::vector<BookInstance> instances;
  const std::vector<Light>& lights;
  std::vector<std::shared_ptr<const Unmirrored>> unmirrored{};  ///< spheres that some of `instances` approximate
};

BookScene book_scene(const Scene& scene, const View& view, const Settings& settings);

BookSurface surface_of(const BookScene& scene, const BookInstance& instance, const MeshTriangle& triangle);

/// A texel in levels, 0 to 255. `index` counts row by row from the top left.
Vec3d texel_of(const Texture& texture, std::size_t index);

/// "ambient", "point", "directional"
std::string_view kind_name(const Light& light);

}  // namespace ps
