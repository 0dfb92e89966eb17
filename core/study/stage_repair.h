#pragma once
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "frame/working_scene.h"
#include "raster/pixel_replay.h"
#include "study/stage_causes.h"

namespace ps {

struct RepairedPixel {
  StageCause cause = StageCause::unexplained;
  /// Where coverage makes two triangles of one: of the sample from their nearest edge, pixels.
  double edge_distance = 0;
};

/// Draws single pixels of the rasterizer again with the values of one stage after the other taken from another
/// renderer.
class StageRepair {
 public:
  StageRepair(const StageRequest& request, Prepared& prepared, StudyControl& control);

  /// The cause of a pixel that differs; `wanted` is what the other renderer shows.
  RepairedPixel cause_of(Vec2i pixel, const Rgb8& wanted);

 private:
  using Covering = std::vector<raster::CoveringTriangle>;
  /// A pixel while its causes are tried.
  struct Pixel {
    Vec2i at;
    Rgb8 wanted;
    PixelId theirs;               ///< what they show
    Covering covering;            ///< what covers it in ours
    std::optional<PixelId> ours;  ///< what ours shows
  };

  bool equal(const Pixel& pixel, const Vec3f& colour) const;
  bool shows(const Pixel& pixel, const Covering& covering) const;
  /// Our piece of the triangle that both show, or nullptr if they show different ones.
  static const raster::CoveringTriangle* same_in_both(const Pixel& pixel);
  /// The triangle at the pixel, whether we find it there or clipping has taken it away.
  std::optional<raster::CoveringTriangle> piece_of(const PixelId& id, Vec2i pixel);
  /// Their depth of a triangle at the pixel, as they compare it; nothing where they do not cover it.
  std::optional<float> their_depth(const PixelId& id, Vec2i pixel);
  bool was_cut(const PixelId& id, Vec2i pixel);
  /// Our triangles with coverage as theirs, of those that clipping cut or of those that it did not.
  enum class Touched { whole, cut };
  Covering with_their_coverage(const Pixel& pixel, Touched touched);
  /// Do the depths of theirs prefer what they show to what we show?
  bool depths_prefer_theirs(const Pixel& pixel);
  static Covering without_ours(const Pixel& pixel, const Covering& covering);
  raster::GivenFragment interpolated(Vec2i pixel) const;
  void add_texels(Vec2i pixel, raster::GivenFragment& given) const;

  bool coverage(Pixel& pixel);
  bool depth(Pixel& pixel);
  bool clipping(Pixel& pixel);
  bool interpolation(const Pixel& pixel);
  bool filtering(const Pixel& pixel);
  bool missing_effect(const Pixel& pixel) const;
  std::optional<StageCause> together(Pixel& pixel);
  double edge_distance(const Pixel& pixel) const;

  const StageRequest& request_;
  const WorkingScene working_;
  StudyControl& control_;
  std::shared_ptr<const StageValues> stages_;
  raster::PixelReplay replay_;
  Image<Rgb8> without_effects_;
  std::map<std::pair<int, int>, StageValues::SeenAlone> alone_;  ///< single triangles in theirs
  std::size_t alone_size_ = 0;                                   ///< depths that they hold
};

/// The settings with which the rasterizer leaves out what a renderer lacks: those of the renderer, with defaults for
/// what it does not act on.
Settings honoured_settings(const Settings& settings, const StageValues& stages);

}  // namespace ps
