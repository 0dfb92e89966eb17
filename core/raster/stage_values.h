#pragma once
#include <functional>
#include <memory>
#include <optional>

#include "frame/frame.h"
#include "raster/environment/environment_map.h"
#include "raster/shadow/shadow_map.h"

namespace ps {

/// What a renderer that draws triangles has after each of its stages, for the sample at the centre of each pixel, one
/// sample per pixel. Another renderer can go on from any of them (raster/pixel_replay.h). Images without pixels: the
/// renderer has no such values under these settings.
struct StageValues {
  int subpixel_bits = 8;  ///< to which it rounds vertices

  /// What the nearest triangle has at the pixels that one covers where no limit of depth cuts it away.
  struct Seen {
    Image<PixelId> triangles;  ///< object and triangle, also of spheres their true triangle; -1 = none
    Image<float> z;            ///< camera space
    Image<float> depth;        ///< as the depth test compares it, 0 to 1
  };
  /// Where one triangle alone is seen, and its depth there.
  struct SeenAlone {
    TileRect box;        ///< around the pixels that it covers
    Image<float> depth;  ///< in the box, as the depth test compares it, 0 to 1; -1 where it covers nothing
    /// Its depth at a pixel of the picture, or nothing where it does not cover it.
    std::optional<float> at(Vec2i pixel) const {
      if (!depth.contains(pixel.x - box.x0, pixel.y - box.y0)) return {};
      const float here = depth.at(pixel.x - box.x0, pixel.y - box.y0);
      if (here < 0) return {};
      return here;
    }
  };

  // After coverage and depth test.
  Seen seen;
  bool larger_is_nearer = false;  ///< of depths
  /// One triangle alone. From any thread, one call at a time, while scene and Prepared of the call that made this live.
  std::function<SeenAlone(const PixelId&)> draw_alone;

  // After interpolation, as it comes: no map has changed it, and normals have any length.
  Image<Vec3f> position, normal;  ///< world space
  Image<Vec2f> uv;
  Image<Vec3f> light, extra;  ///< of Gouraud and flat shading: what multiplies the surface's colour, what is added

  // After textures.
  Image<Vec3f> surface;            ///< the surface's own colour
  Image<Vec3f> mapped_normal;      ///< shading normal, world space
  Image<Vec3f> specular, ambient;  ///< colours of the material's answer to light

  // What textures are drawn beforehand; null where none is read.
  std::shared_ptr<const raster::ShadowMaps> shadow_maps;
  std::shared_ptr<const raster::EnvironmentMaps> environment;
  /// Of stencil shadows: bit i set where light i does not reach the surface.
  Image<std::uint32_t> in_shadow;
};

}  // namespace ps
