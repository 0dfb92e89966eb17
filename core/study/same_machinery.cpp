#include "study/same_machinery.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/check.h"
#include "options/renderer_kind.h"

namespace ps {
namespace {

/// Why two pictures are not drawn on the same code path, from the view of the slower one.
struct Mismatch {
  std::size_t slower = 0;
  std::string_view reason;
};

/// A graphics driver draws with its own code, whatever the others are held to.
bool is_driver(const FastPath& path) { return path.machinery == Machinery::driver; }

std::string_view words_of(const std::vector<FastPath>& paths) {
  const bool driver = std::any_of(paths.begin(), paths.end(), is_driver);
  if (std::all_of(paths.begin(), paths.end(), is_driver)) return "by the graphics driver, its draw calls alone";
  const bool scalar =
      std::any_of(paths.begin(), paths.end(), [](const FastPath& path) { return path.machinery == Machinery::clear; });
  if (driver)
    return scalar ? "scalar code beside the draw calls of the graphics driver"
                  : "SIMD code beside the draw calls of the graphics driver";
  return scalar ? "all on scalar code" : "all on SIMD code";
}

std::optional<Mismatch> find_mismatch(std::span<const Settings> settings, const std::vector<FastPath>& paths) {
  for (std::size_t i = 0; i < paths.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const bool scalar = paths[i].machinery == Machinery::clear || paths[k].machinery == Machinery::clear;
      const bool renderers_differ = settings[i].renderer != settings[k].renderer;
      if (paths[i].same_machinery(paths[k]) || is_driver(paths[i]) || is_driver(paths[k])) continue;
      // Each renderer has fast code of its own.
      if (renderers_differ && !scalar) continue;
      const auto rank = [&](std::size_t p) {
        return 4 * static_cast<int>(paths[p].machinery) + static_cast<int>(paths[p].shading);
      };
      const std::size_t slower = rank(i) < rank(k) ? i : k;
      return Mismatch{slower, paths[slower].reason};
    }
  return {};
}

bool searches_embree(const Settings& settings) {
  return sends_rays(settings.renderer) && settings.accelerator == Accelerator::embree;
}

}  // namespace

TimedSettings on_same_machinery(std::span<const Settings> settings, std::span<const std::string> labels,
                                const SceneTraits& traits, MachineryRule rule) {
  PS_ASSERT(settings.size() == labels.size(), "one label for each");
  TimedSettings timed;
  timed.settings.assign(settings.begin(), settings.end());
  if (settings.empty()) return timed;
  std::vector<FastPath> paths;
  for (const Settings& one : settings) paths.push_back(fast_path(one, traits, Channel::none));
  timed.machinery = paths.front().machinery;
  const std::optional<Mismatch> mismatch = find_mismatch(settings, paths);
  if (!mismatch) {
    timed.reason = words_of(paths);
    return timed;
  }
  const bool simd_differs = std::any_of(settings.begin(), settings.end(),
                                        [&](const Settings& one) { return one.simd != settings.front().simd; });
  if (rule == MachineryRule::as_used || simd_differs) {
    timed.same = false;
    timed.reason = simd_differs ? "on SIMD and scalar code: SIMD itself is compared"
                                : "as used, some on SIMD and some on scalar code: times compare code, not techniques";
    return timed;
  }
  for (Settings& one : timed.settings) one.simd = Simd::off;
  timed.machinery = Machinery::clear;
  const bool driver = std::any_of(paths.begin(), paths.end(), is_driver);
  timed.reason = fmt::format("all on scalar code{}, because of '{}': {}",
                             driver ? " beside the draw calls of the graphics driver" : "", labels[mismatch->slower],
                             mismatch->reason);
  if (std::any_of(settings.begin(), settings.end(), [](const Settings& one) { return searches_embree(one); }))
    timed.reason += "; Embree searches its tree by SIMD code of its own";
  return timed;
}

}  // namespace ps
