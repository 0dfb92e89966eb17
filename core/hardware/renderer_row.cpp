#include "hardware/renderer.h"

#include "hardware/fast_path.h"
#include "hardware/gl_thread.h"
#include "hardware/lacks.h"
#include "hardware/render.h"
#include "hardware/shader_listing.h"
#include "raster/setup/left_out.h"

namespace ps {
namespace {

/// Some options are its own; of all others it uses what it does not lack.
std::optional<bool> reads(const Option& option, const Settings&, const SceneTraits&) {
  if (option.acts_for == ActsFor::readers && option.known_to.hardware.asked) return true;
  return {};
}

std::vector<LeftOut> left_out(const SceneTraits& traits, const Settings& settings) {
  constexpr std::string_view subject = "The hardware renderer";
  const Remedy rasterizer{"Rasterizer", "renderer=rasterizer"};
  std::vector<LeftOut> all = left_out_by_fragments(traits, settings, subject);
  if (auto rounded = rounded_by_fragments(traits, settings, subject, rasterizer)) {
    all.push_back(std::move(*rounded));
  } else if (traits.outgrows_float && settings.camera_relative) {
    all.push_back({LeftOutKind::effect,
                   {BriefVerb::own, "rounds away detail in float"},
                   "The hardware renderer rounds away detail: it lies too far from the middle of its model. Set "
                   "renderer = rasterizer to see it.",
                   "Detail is rounded away: drivers compute in float.",
                   {rasterizer}});
  }
  return all;
}

std::optional<IdleReason> why_unavailable(const Settings&, const SceneTraits&) {
  const hardware::Availability& available = hardware::availability();
  if (available.driver) return {};
  return IdleReason(std::string_view(available.reason));
}

bool shows_objects(const SceneTraits& traits, const Settings&) {
  return traits.spheres || traits.triangles || traits.solids || traits.canvas_items;
}

}  // namespace

RendererKind hardware_renderer_kind() {
  return {.key = "hardware",
          .label = "hardware (OpenGL)",
          .help = "Draws triangles with OpenGL, on the graphics processor or with a driver that emulates one.",
          .way = PictureWay::fragments,
          .reads = reads,
          .unread = "the hardware renderer does not use it",
          .lacks_option = hardware::lacks_option,
          .lacks_value = hardware::lacks_value,
          .inactive = why_unavailable};
}

bool hardware_driver_is_known() { return hardware::driver_is_known(); }

RendererRow hardware_renderer_row() {
  return {.render = hardware::render_hardware,
          .inspect = hardware::inspect_hardware,
          .counts = {Counter::triangles_in, Counter::pixels_written, Counter::nan_pixels},
          .fast_path = [](const Settings&, const SceneTraits&, Channel) { return hardware::hardware_path(); },
          .by_driver = true,
          .left_out = left_out,
          .shows_objects = shows_objects,
          .subject = [](const SceneTraits&, const Settings&) { return std::string("the hardware renderer"); },
          .shaders = hardware::list_shaders,
          .reload_shaders = hardware::reload_shaders};
}

}  // namespace ps
