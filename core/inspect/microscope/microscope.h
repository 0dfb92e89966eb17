#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frame/prepared.h"
#include "frame/view.h"
#include "image/image.h"
#include "inspect/face_data.h"
#include "inspect/microscope/surroundings.h"
#include "record/story.h"
#include "scene/scene.h"

namespace ps {

/// One pixel as large as a panel: what lies in it, where its samples are and who gets each of them. Places in the pixel
/// are in pixels from its top left corner, y down: the pixel is the unit square, and its surroundings are shown too.

/// How far around the pixel is shown, in pixels.
inline constexpr double micro_margin = 0.25;

/// A triangle near the pixel, with what the rasterizer computes for it at one sample point.
struct MicroTriangle {
  PixelId id;
  std::string name;
  std::array<Vec2d, 3> corners{};      ///< in the pixel, after rounding to the sub-pixel grid
  std::array<double, 3> edges{};       ///< edge function values at the point, square pixels; positive = inside
  std::array<bool, 3> ties{};          ///< the edge passes exactly through the point
  std::array<bool, 3> owns{};          ///< the fill rule gives points on the edge to this triangle
  std::array<double, 3> weights_2d{};  ///< barycentric, on the screen
  std::array<double, 3> weights{};     ///< perspective-correct
  double z = 0;                        ///< camera space, as the kernel has it
  double z_2d = 0;                     ///< the vertices' z by the weights of the screen: not where the surface is
  std::optional<Vec2d> uv, uv_2d;      ///< perspective-correct, and by the weights of the screen
  std::optional<FaceData> face;        ///< of a triangle of a model
  std::optional<double> depth;         ///< encoded, as the depth buffer compares it; nothing where it compares none
  bool covered = false;
  bool cut_out = false;  ///< an opacity map leaves nothing of it at the point
  bool back_face = false;
  bool on_canvas = false;  ///< drawn flat, after the scene: no depth, and no weights but those of the screen
  bool is_drawn() const { return covered && !cut_out; }
};

/// A level of a texture around the place that was read. Places are in texels of the level from the top left of the
/// texture, and go on beyond its borders as wrapping asks.
struct MicroTexels {
  int level = 0;
  int x0 = 0, y0 = 0;            ///< of the first texel shown
  Image<Rgb8> texels;            ///< as they are
  std::vector<Vec2d> footprint;  ///< the pixel's outline on the texture; empty for rays, which have none
  Vec2d place{0, 0};             ///< where the lookup is
  struct Tap {
    int x = 0, y = 0;
    double weight = 0;  ///< share of the result
  };
  std::vector<Tap> taps;
};

struct MicroTexture {
  TextureEvent lookup;
  std::vector<MicroTexels> levels;  ///< those that were read
};

/// What there is at one sample point.
struct MicroReading {
  Vec2d point{0.5, 0.5};  ///< on the grid that vertices and samples lie on (rasterizer), or anywhere (ray tracer)
  std::vector<MicroTriangle> triangles;  ///< in drawing order
  int front = -1;                        ///< of them, the one that would be seen at the point; -1 = none
  std::optional<PixelStory> ray;        ///< of the ray through the point (ray tracer), or of a pixel around it (driver)
  std::optional<FacePoint> face;        ///< of the triangle that `ray` shows, if it is one of a model
  std::optional<MicroTexture> texture;  ///< read by the triangle in front, or where the ray hits
  std::string seen;                     ///< "triangle 7 of cube 1", "an edge of cube 1", "the background"
};

/// One of the pixel's own samples.
struct MicroSample {
  Vec2d position{0.5, 0.5};
  bool lit = false;  ///< something covers it, or its ray hit something
  std::string seen;
  int event = -1;  ///< of the pixel's story, if the story has it
};

/// How finely a pixel's picture is drawn.
enum class MicroDetail {
  first,  ///< what can be shown at once: a coarse picture, or the whole one where that takes no time to speak of
  whole
};

/// What is drawn of a pixel and asked about it. Made once for each pixel; then any sample point can be read.
class Microscope {
 public:
  /// The pixel must lie in the view. Throws Cancelled.
  Microscope(Scene scene, const View& view, const Settings& settings, Vec2i pixel, Prepared& prepared,
             Progress& progress, MicroDetail detail = MicroDetail::whole);
  ~Microscope();
  Microscope(const Microscope&) = delete;  // the fragments refer to the scene in it
  Microscope& operator=(const Microscope&) = delete;

  Vec2i pixel() const { return pixel_; }
  const Settings& settings() const { return settings_; }
  /// What both renderers see in the pixel and its margin, as a picture of its own.
  const Image<Rgb8>& enlarged() const { return enlarged_; }
  /// How fine that picture is. All else is the same for both, but for what unrecorded samples of a pixel with very many
  /// are said to see: that is read from the picture.
  MicroDetail detail() const { return detail_; }
  const std::vector<MicroSample>& samples() const { return samples_; }
  /// What lies around the pixel where no edge runs through it or its margin; nullopt where one does, or where only a
  /// coarse picture was made.
  const std::optional<PixelSurroundings>& surroundings() const { return surroundings_; }
  /// What there is at a point of the pixel or its margin. Rasterizer: the edge functions and weights are those of the
  /// kernel with its sample moved there. Ray tracer: the story of a ray through the point. A graphics driver, which
  /// reports no edges: the story of a picture of one small pixel around the point.
  MicroReading read(const Vec2d& point, Prepared& prepared, Progress& progress) const;

  /// The rasterizer's part, in the precision that the settings ask for.
  class Fragments;

 private:
  std::string seen_at(const Vec2d& point) const;
  void draw_enlarged(int pixels, Prepared& prepared, Progress& progress);
  bool has_edge() const;
  void find_ray_samples(Prepared& prepared, Progress& progress);
  void find_driver_sample(Prepared& prepared, Progress& progress);
  void find_line(Prepared& prepared, Progress& progress);

  Scene scene_;
  View view_;
  Settings settings_;
  Vec2i pixel_;
  MicroDetail detail_ = MicroDetail::whole;
  Image<Rgb8> enlarged_;
  Image<PixelId> enlarged_ids_;
  std::vector<MicroSample> samples_;
  std::optional<PixelSurroundings> surroundings_;
  std::unique_ptr<Fragments> fragments_;  // null for rays
  std::string line_;                      // that lies over the whole pixel; empty: none
};

}  // namespace ps
