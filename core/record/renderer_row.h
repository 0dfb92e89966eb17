#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "frame/frame.h"
#include "frame/left_out.h"
#include "frame/prepared.h"
#include "frame/slow_motion.h"
#include "frame/view.h"
#include "record/story.h"

namespace ps {

struct FieldInputs;    // record/field_inputs.h
struct ShaderListing;  // record/shader_listing.h

/// A renderer, as everything above the renderers knows it: one row of the table in render/renderer_table.h. All
/// functions are there but those that say when they are not.
struct RendererRow {
  Renderer renderer{};  ///< its number; add_renderer() gives one to those that come with a program

  /// The picture; see render() in render/render.h. Of the channels it fills those that it can.
  Frame (*render)(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
                  Prepared& prepared, Progress& progress) = nullptr;
  /// Events, colour, levels and counters of one pixel; verdict and ledger only where they are not made of the events.
  PixelStory (*inspect)(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel, Prepared& prepared,
                        Progress& progress) = nullptr;
  /// One number of every pixel's story, by the kernels that inspect() runs, into an image of NaN. nullptr: it reports
  /// its steps for one pixel at a time.
  void (*find_field)(const FieldInputs& asked, Image<float>& values, Prepared& prepared, Progress& progress) = nullptr;
  /// Are its numbers values on the lines of a listing, not fields of events?
  bool finds_lines = false;
  /// The counters that both give; all others are absent from frames and stories.
  CounterSet counts;
  /// The code path that draws a whole picture, and why not a faster one.
  FastPath (*fast_path)(const Settings& settings, const SceneTraits& traits, Channel channels) = nullptr;
  /// A graphics driver transforms its vertices and decides which samples a triangle covers, and reports neither
  /// positions nor edges: those that the rasterizer computes are not its.
  bool by_driver = false;
  /// The parts of such a scene that it cannot show, with the reason and what shows them.
  std::vector<LeftOut> (*left_out)(const SceneTraits& traits, const Settings& settings) = nullptr;
  /// Does it show any object of such a scene?
  bool (*shows_objects)(const SceneTraits& traits, const Settings& settings) = nullptr;
  /// Its name as the subject of a sentence: "the ray tracer".
  std::string (*subject)(const SceneTraits& traits, const Settings& settings) = nullptr;
  /// Why it cannot show the picture after n of these units; nullopt if it can. nullptr: it can for no unit.
  std::optional<std::string_view> (*slow_motion_lacks)(SlowUnit unit, const Settings& settings,
                                                       const SceneTraits& traits) = nullptr;
  /// The picture after `motion.at` units. Of `request` only channels, region and priority count. Not called for a unit
  /// that it lacks.
  SlowFrame (*slow_motion)(const Scene& scene, const View& view, const Settings& settings, const SlowMotion& motion,
                           const RenderRequest& request, Prepared& prepared, Progress& progress) = nullptr;
  /// The shaders that drew a pixel, or nullptr: it has none. Throws as render() does.
  std::shared_ptr<const ShaderListing> (*shaders)(const Scene& scene, const View& view, const Settings& settings,
                                                  Vec2i pixel, Prepared& prepared, Progress& progress) = nullptr;
  /// Reads the files of the shaders anew; its next picture is drawn with them, and what pictures before have left in
  /// Prepared holds no longer. Gives why they do not compile
  /// ("lighting.glsl:15: ..."), in which case the ones before stay in use; empty: they do. nullptr: it has none.
  std::string (*reload_shaders)() = nullptr;
};

}  // namespace ps
