#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "hardware/corner_capture.h"
#include "hardware/picture_drawer.h"
#include "hardware/story_pages.h"
#include "record/recorder.h"
#include "record/story.h"

namespace ps::hardware {

/// A triangle that may reach the pixel, and what the driver reports of it.
struct NearTriangle {
  DrawRun run;  ///< it alone
  PixelId id;
  int sphere_triangle = -1;                   ///< of a sphere; -1: it has a number of its own
  unsigned covered = 0;                       ///< samples, as bits
  bool front = true;                          ///< gl_FrontFacing
  bool culled = false;                        ///< seen from behind, and the options drop backs
  bool cut_out = false;                       ///< by its opacity map
  bool outside = false;                       ///< of the near and far limits that a shader tests
  std::optional<CapturedTriangle> corners{};  ///< asked for once
};

/// Draws what a picture is made of at one pixel once more, triangle by triangle and pass by pass, and asks the driver
/// after each what happened. The picture's own programs and passes decide about depth, stencil and colour; programs
/// that share their functions report what those compute on the way. On the thread of OpenGL only.
class StoryDrawer : private PictureDrawer {
 public:
  /// `plan` has the pixel as its region and no channels.
  StoryDrawer(const PicturePlan& plan, Workshop& shop, Vec2i pixel);
  ~StoryDrawer();
  StoryDrawer(const StoryDrawer&) = delete;
  StoryDrawer& operator=(const StoryDrawer&) = delete;

  /// Events, colour and counters of the pixel.
  void report(PixelStory& story);

 private:
  /// What the driver keeps of each sample of the pixel, and what a triangle brings there; in the order of the samples.
  struct SampleValues {
    std::vector<float> stored, own;  ///< depths, before and of the triangle; empty where nothing can read them
    std::vector<int> stencil;        ///< before; empty without a stencil buffer
  };
  /// What became of a triangle in a pass.
  struct Outcome {
    FragmentEvent::Depth depth = FragmentEvent::Depth::off;
    std::optional<double> stored;        ///< in the depth buffer, before
    std::optional<double> stored_after;  ///< of a triangle that wrote its depth
    std::optional<int> stencil;          ///< in the stencil buffer, before; with several samples at `sample`
    unsigned sample = 1;                 ///< as a bit: the first of those that it covers
    SampleValues samples;                ///< where the pixel has several
    Vec3d before{0, 0, 0}, after{0, 0, 0};
    unsigned written = 0;  ///< samples, as bits
  };

  // Which triangles there are (story_drawer.cpp).
  void find_near(PixelStory& story);
  void find_covering();
  void guard_neighbours() const;
  Vec4f look_at_samples(Program& program, NearTriangle& triangle) const;
  int samples() const { return sample_count(plan_.settings); }
  unsigned all_samples() const { return (1u << samples()) - 1; }

  // Passes (story_passes.cpp).
  void report_pass(const DrawPass& pass);
  void report_triangle(NearTriangle& triangle, const DrawPass& pass);
  void report_deferred(const DrawPass& pass);
  void report_canvas();

  // Shadow volumes (story_volumes.cpp).
  /// What the stencil buffer held after the faces of the light's volumes were counted, and which were.
  void report_stencil(const DrawPass& pass, const Outcome& outcome, double z);
  /// At one of the samples, given as a bit, as below.
  StencilEvent stencil_event(std::size_t light, unsigned sample);
  /// `face` counts in the order in which the volume is drawn; `triangle` is its number in the volume.
  std::optional<VolumeCrossing> crossing(const raster::ShadowVolume& volume, const VolumeBuffers& buffers, int face,
                                         std::size_t triangle, unsigned sample);
  /// Adds those of some faces that reach the pixel. In a state that tests nothing.
  void find_faces(int first, int count, unsigned sample, std::vector<int>& found) const;
  Outcome draw_really(const DrawPass& pass, unsigned among, const std::function<void()>& draw);
  bool depth_is_equal(const DrawPass& pass, const std::function<void()>& draw);
  void bind_picture(const DrawPass& pass) const;
  unsigned count_samples(unsigned among, const std::function<void()>& draw) const;
  /// The mean of the pixel's samples.
  Vec3d colour_now() const;
  /// Once all samples are drawn: the pixel of the resolved picture, which shapes on the canvas are drawn on.
  Vec3d resolved_colour() const;
  std::optional<double> depth_now() const;

  // Samples (story_samples.cpp).
  SampleValues look_at_values(unsigned among, const std::function<void()>& draw);
  /// Which of the samples are written, and what decided about each that the triangle covers.
  CoverageEvent samples_event(const NearTriangle& triangle, unsigned covered, const Outcome& outcome) const;

  // Asking (story_pages.cpp).
  Program& story_program(std::size_t surface);
  Program& deferred_story_program();
  /// What draws a fragment for its pages.
  struct Asked {
    Program& program;
    unsigned covered = 1;  ///< samples, as bits
    std::function<void()> draw;
  };
  Vec4f page(const Asked& asked, Page page) const;
  /// What the program in use writes at one of the samples.
  Vec4f value_written(unsigned covered, const std::function<void()>& draw) const;
  void begin_asking() const;

  // Events (story_events.cpp).
  FragmentEvent fragment_event(NearTriangle& triangle, const Asked& asked, const DrawPass& pass,
                               const Outcome& outcome);
  void report_surface(const NearTriangle& triangle, const Asked& asked);
  void report_lights(const FragmentEvent& fragment, NearTriangle& triangle, const Asked& asked, const DrawPass& pass,
                     const Outcome& outcome);
  void report_vertex_lights(const FragmentEvent& fragment, NearTriangle& triangle, const DrawPass& pass);
  bool shows_surroundings(const NearTriangle& triangle) const;
  void report_mirror(const NearTriangle& triangle, const Asked& asked);
  void report_write(const FragmentEvent& fragment, NearTriangle& triangle, const Asked& asked, const DrawPass& pass,
                    const Outcome& outcome);
  const CapturedTriangle& corners_of(NearTriangle& triangle, const DrawPass& pass);
  CapturedTriangle capture(const NearTriangle& triangle, const DrawPass& pass, int light);
  int first_light_of(const DrawPass& pass) const;
  int end_light_of(const DrawPass& pass) const;

  Vec2i pixel_;
  PixelRecorder recorder_;
  std::vector<NearTriangle> near_;
  int winner_ = -1;  ///< of deferred shading: index into near_
};

}  // namespace ps::hardware
