#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "raster/clear/bins.h"
#include "raster/clear/fragment.h"
#include "raster/stage_values.h"

namespace ps::raster {

/// A triangle, or the piece of one that clipping left, that covers the sample of a pixel.
struct CoveringTriangle {
  PrimitiveRef ref;
  PixelId id;        ///< its true triangle, also of a sphere
  float depth = 0;   ///< encoded, as it is compared
  bool cut = false;  ///< clipping made edges of it
  bool operator==(const CoveringTriangle& other) const {
    return ref.batch == other.ref.batch && ref.index == other.ref.index && depth == other.depth;
  }
};

/// Values of one fragment from elsewhere, in place of the rasterizer's own. Absent ones stay its own.
struct GivenFragment {
  std::optional<float> z;  ///< camera space
  std::optional<Vec3f> position, normal, light, extra;
  std::optional<Vec2f> uv;
  std::optional<Vec3f> surface, mapped_normal, specular, ambient;  ///< in place of what textures give
};

/// Whose shadow and environment maps, and whose stencil buffer, shading reads.
enum class ReplayMaps { own, given };

/// Repeats the work of the rasterizer's clear path for single pixels, and lets values of its stages be replaced
/// (StageValues): what would the picture show if one stage had done as another renderer did? In float, one sample per
/// pixel. Without replaced values it gives the rasterizer's picture, bit for bit.
class PixelReplay {
 public:
  /// The settings' renderer does not matter. Scene and view must outlive it.
  PixelReplay(const Scene& scene, const View& view, const Settings& settings, Prepared& prepared, Progress& progress);
  ~PixelReplay();
  PixelReplay(const PixelReplay&) = delete;
  PixelReplay& operator=(const PixelReplay&) = delete;

  /// Makes shade() read these with ReplayMaps::given. `in_shadow` holds bits as in StageValues.
  void give_maps(std::shared_ptr<const ShadowMaps> shadows, std::shared_ptr<const EnvironmentMaps> environment,
                 const Image<std::uint32_t>& in_shadow);

  /// All triangles that cover the pixel, in drawing order.
  std::vector<CoveringTriangle> covering(Vec2i pixel) const;
  /// The one that is seen, by their depths or in drawing order, as the settings ask; -1 where there is none.
  int winner(const std::vector<CoveringTriangle>& covering) const;
  /// The piece of a triangle whose edges the pixel lies least outside of, as if it covered the pixel; nothing where all
  /// of the triangle was clipped away, turned away or has no area.
  std::optional<CoveringTriangle> nearest_piece(const PixelId& id, Vec2i pixel) const;
  /// The same of the triangle cut by no plane but one near the eye.
  std::optional<CoveringTriangle> uncut(const PixelId& id, Vec2i pixel);
  /// How far the sample lies within the nearest edge: pixels, below 0 outside.
  double within_edges(const CoveringTriangle& triangle, Vec2i pixel) const;

  /// What the whole triangle, not its pieces, has at the pixel, in double; for GivenFragment.
  GivenFragment whole_triangle_at(const CoveringTriangle& triangle, Vec2i pixel) const;

  /// The colour of the pixel if it shows this triangle; linear, with the canvas items that lie over it.
  Vec3f shade(const CoveringTriangle& triangle, Vec2i pixel, const GivenFragment& given = {},
              ReplayMaps maps = ReplayMaps::own) const;
  /// The colour of a pixel that shows no triangle.
  Vec3f background(Vec2i pixel) const;

 private:
  struct State;
  Vec3f with_canvas_items(Vec3f colour, Vec2i pixel) const;
  std::unique_ptr<State> state_;
};

}  // namespace ps::raster
