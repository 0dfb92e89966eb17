#include "render/slow_motion.h"

#include <fmt/format.h>

#include "base/check.h"
#include "base/number_text.h"
#include "base/stop.h"
#include "frame/fast_kernels.h"
#include "frame/working_scene.h"
#include "image/image.h"
#include "render/renderer_table.h"
#include "render/story/names.h"

namespace ps {
namespace {

constexpr std::string_view driver_draws =
    "the graphics driver draws in an order of its own and gives only finished pictures";

/// The name of the last one, after a colon; empty where it has none.
std::string last_words(const SlowState& state, const Scene& scene, Vec2i size) {
  std::string words;
  const auto add = [&](const std::string& more) { words += (words.empty() ? ": " : ", ") + more; };
  if (!state.stage.empty()) add(std::string(state.stage));
  if (state.pixel) {
    add(fmt::format("({}, {})", state.pixel->x, state.pixel->y));
    if (state.done.unit == SlowUnit::pixels) add(fmt::format("row {} of {}", state.pixel->y + 1, size.y));
  }
  if (state.id.object >= 0) add(primitive_name(scene, state.id));
  if (state.box && state.done.unit == SlowUnit::tiles)
    add(fmt::format("columns {} to {}, rows {} to {}", state.box->x0, state.box->x1 - 1, state.box->y0,
                    state.box->y1 - 1));
  if (state.done.unit == SlowUnit::samples) add("each pixel is the mean of its samples so far");
  return words;
}

/// Channels that are made of two pictures, neither of which may be cut short.
bool compares_pictures(Channel channels) {
  return has(channels, Channel::precision) || has(channels, Channel::depth_gap);
}

}  // namespace

std::optional<SlowMotion> given_slow_motion(const std::optional<SlowMotion>& asked, const Settings& settings,
                                            const SceneTraits& traits, ShownChannel shown) {
  if (!asked || compares_pictures(shown_channel(shown).needs)) return {};
  return slow_motion_lacks(asked->unit, settings, traits) ? std::nullopt : asked;
}

std::optional<std::string_view> slow_motion_lacks(SlowUnit unit, const Settings& settings, const SceneTraits& traits) {
  const RendererRow& row = renderer_row(settings.renderer);
  if (!row.slow_motion) return driver_draws;
  return row.slow_motion_lacks(unit, settings, traits);
}

std::optional<SlowUnit> first_slow_unit(const Settings& settings, const SceneTraits& traits) {
  for (const SlowUnitRow& row : slow_units())
    if (!slow_motion_lacks(row.unit, settings, traits)) return row.unit;
  return {};
}

SlowFrame render_slowly(const Scene& scene, const View& view, const Settings& settings, const SlowMotion& motion,
                        const RenderRequest& request, Prepared& prepared, Progress& progress) {
  require_image_size(view.width, view.height, "picture");
  if (compares_pictures(request.channels))
    throw InputError("slow motion: this channel compares two whole pictures. Show another one.");
  if (const auto lack = slow_motion_lacks(motion.unit, settings, prepared_traits(scene, prepared)))
    throw InputError(fmt::format("slow motion by {}: {}", slow_unit(motion.unit).key, *lack));
  const StopScope stop(&progress);
  const RendererRow& row = renderer_row(settings.renderer);
  const WorkingScene working(scene, view, settings, prepared);
  SlowFrame slow =
      row.slow_motion(working.scene(), working.view(), working.settings(), motion, request, prepared, progress);
  working.to_world(slow.frame);
  CounterSet given;
  for (std::size_t i = 0; i < counter_count; ++i)
    if (const auto counter = static_cast<Counter>(i);
        row.counts.contains(counter) && slow.frame.counters.given.contains(counter))
      given.insert(counter);
  slow.frame.counters.given = given;
  return slow;
}

std::string slow_motion_words(const SlowState& state, const Scene& scene, Vec2i size) {
  const std::string_view one = slow_unit(state.done.unit).one;
  const std::string total = with_thousands(std::to_string(state.total));
  if (state.done.at == 0) return fmt::format("nothing yet of {} {}", total, slow_unit(state.done.unit).many);
  return fmt::format("{} {} of {}{}", one, with_thousands(std::to_string(state.done.at)), total,
                     last_words(state, scene, size));
}

}  // namespace ps
