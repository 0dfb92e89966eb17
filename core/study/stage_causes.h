#pragma once
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "render/render.h"
#include "study/control.h"

namespace ps {

/// Why two renderers that draw triangles show different pixels, in the order in which the causes are tried.
enum class StageCause : std::uint8_t {
  none,            ///< the pixel is the same within the bound
  coverage,        ///< another triangle covers the sample, or the face of a shadow volume does
  depth_tie,       ///< both cover it, and the depth test decides otherwise
  clipping,        ///< a plane cut the triangle, or cut it away
  interpolation,   ///< z, position, normal, texture coordinates or light of vertices have other values
  filtering,       ///< a texture, shadow map or environment map gives other values
  missing_effect,  ///< the options differ, or one of the renderers does not act on one
  unexplained
};
inline constexpr std::size_t stage_cause_count = 8;

/// "depth tie"
std::string_view stage_cause_label(StageCause cause);
/// One sentence: which repair makes such a pixel equal.
std::string_view stage_cause_help(StageCause cause);
Rgb8 stage_cause_colour(StageCause cause);

/// What belongs to one cause.
struct StageShare {
  long pixels = 0;   ///< those that differ in colour beyond the bound, in what is seen, or in both
  long colours = 0;  ///< of these, those that differ in colour beyond the bound
  long ids = 0;      ///< of these, those that show another object or triangle
  double error = 0;  ///< sum over their channels of the difference in colour: levels of 255
};

/// The difference between two pictures, pixel by pixel divided among the causes.
struct StageSplit {
  Image<StageCause> causes;
  std::array<StageShare, stage_cause_count> shares{};  ///< they add up to `whole`
  StageShare whole;
  int largest = 0;  ///< difference of one channel, levels of 255
  /// Of pixels that show another triangle, if only of the same object, because of coverage alone: how far the sample
  /// lies from the nearest edge of the two triangles, pixels. The largest of them.
  double edge_distance = 0;
  const StageShare& share(StageCause cause) const { return shares[static_cast<std::size_t>(cause)]; }
  /// Of the pixels, from 0 to 1; 0 where none differs.
  double part(StageCause cause) const;
};

struct StageRequest {
  Scene scene;
  View view;
  Settings other;  ///< of a renderer that gives the values of its stages
  Settings ours;   ///< of the rasterizer
  int bound = 1;   ///< colours that differ by no more are equal: levels of 255
};

/// Why the difference between two pictures cannot be divided this way, or nothing if it can. Either may be the
/// rasterizer's.
std::optional<std::string> why_no_stages(const SceneTraits& traits, const Settings& a, const Settings& b);

/// The first renderer that gives the values of its stages, or nothing where the program has none.
std::optional<Renderer> renderer_with_stages();

/// The request for two pictures of which one is the rasterizer's.
StageRequest stage_request(const Scene& scene, const View& view, const Settings& a, const Settings& b);

/// Divides the difference between the pictures of two renderers among the stages. A pixel belongs to the first cause
/// whose repair makes it equal within the bound: the rasterizer draws it again with that one stage's values taken from
/// the other renderer. Where no stage alone does it, values of all stages up to a cause are taken together. Pictures
/// with several samples per pixel are compared as they are, and repaired by one sample at the centre. Throws Cancelled.
StageSplit split_by_stage(const StageRequest& request, StudyControl& control,
                          const std::function<void(const StudyStatus&)>& update = {});

/// The pixels in the colours of their causes, on dark grey.
Image<Rgb8> stage_picture(const StageSplit& split);

}  // namespace ps
