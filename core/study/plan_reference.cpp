#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/check.h"
#include "options/choice_key.h"
#include "options/renderer_kind.h"
#include "options/robust_rays.h"
#include "study/reference.h"

namespace ps {
namespace {

constexpr int least_samples = 16, most_samples = 4096;
/// Fragments are averaged over a larger picture, which has at most this many pixels: about 1.2 GB in double.
constexpr double most_enlarged_pixels = 0x1p25;
constexpr int most_enlarged_side = 16384;
/// Rays in double are scalar; beyond this many of them, float with SIMD takes their place.
constexpr double most_double_rays = 0x1p24;

using Texts = std::vector<std::string_view>;

Texts split(std::string_view text, char separator) {
  Texts parts;
  while (!text.empty()) {
    const auto end = std::min(text.find(separator), text.size());
    parts.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

bool differs(const Option& option, std::span<const SweepPoint> points) {
  return std::any_of(points.begin(), points.end(), [&](const SweepPoint& point) {
    return option.get(point.value) != option.get(points.front().value);
  });
}

/// "K=V", or "K=V1|V2": V1 for rays, V2 for fragments.
std::string assignment_for(std::string_view text, Renderer renderer) {
  const auto bar = text.find('|');
  if (bar == std::string_view::npos) return std::string(text);
  if (!draws_fragments(renderer)) return std::string(text.substr(0, bar));
  return fmt::format("{}={}", text.substr(0, text.find('=')), text.substr(bar + 1));
}

/// What rays need to show no more than the fragments did.
void trace_what_fragments_show(const Settings& fragments, Settings& rays) {
  const bool none = fragments.shadows == Shadows::traced || fragments.shadows == Shadows::none;
  rays.shadows = none ? Shadows::none : Shadows::traced;
}

/// Collects what the truth of the swept options asks for.
class Planner {
 public:
  Planner(std::span<const SweepPoint> points, const Settings& base, const SceneTraits& traits)
      : points_(points), traits_(traits) {
    plan_.settings = points.empty() ? base : points.front().value;
    for (const Option& option : option_table())
      if (differs(option, points)) option.set(plan_.settings, option.get(base));
  }

  ReferencePlan plan(const View& view, const ReferenceOptions& options) {
    for (const Option& option : option_table())
      if (differs(option, points_)) take(option);
    be_robust();
    if (options.samples > 1 || (options.samples == 0 && average_)) take_average(view, options.samples);
    describe();
    return std::move(plan_);
  }

 private:
  void take(const Option& option) {
    const Truth& truth = option.truth;
    PS_ASSERT(truth.kind != TruthKind::undeclared, "each option declares its truth");
    average_ = average_ || truth.kind == TruthKind::pixel_average;
    for (const std::string_view text : split(truth.exact, ';')) {
      const std::string assignment = assignment_for(text, plan_.settings.renderer);
      const Settings before = plan_.settings;
      parse_assignment(assignment, plan_.settings);
      if (before.renderer != plan_.settings.renderer) {
        if (!shown_by_rays(before, traits_)) {
          plan_.settings = before;
          continue;
        }
        if (option.key != "renderer" && draws_fragments(before.renderer))
          trace_what_fragments_show(before, plan_.settings);
      }
      if (std::find(exact_.begin(), exact_.end(), assignment) == exact_.end()) exact_.push_back(assignment);
    }
  }

  void be_robust() {
    // Whether a line goes through one pixel or its neighbour is a tie more often than not: there is no better truth.
    if (!shown_by_rays(plan_.settings, traits_)) return;
    plan_.settings = robust_rays(plan_.settings);
  }

  void take_average(const View& view, int asked) {
    int most = 1;
    for (const SweepPoint& point : points_)
      most = std::max({most, point.value.samples_per_pixel, point.value.multisampling});
    int samples = least_samples;
    while (samples < 4 * most && samples < most_samples) samples *= 4;
    Settings& s = plan_.settings;
    s.samples_per_pixel = 1;
    s.sample_pattern = SamplePattern::grid;
    s.adaptive_sampling = false;
    s.subsampling = 1;
    s.multisampling = 1;
    const double pixels = static_cast<double>(view.width) * view.height;
    if (sends_rays(s.renderer)) {
      plan_.samples = asked > 1 ? asked : samples;
      const bool swept_precision = std::any_of(
          exact_.begin(), exact_.end(), [](const std::string& assignment) { return assignment == "precision=double"; });
      if (!swept_precision && 2 * plan_.samples * pixels > most_double_rays) s.precision = Precision::float32;
    } else {
      // A texture's footprint is known to no sample: more of them are needed than for edges.
      int side = std::max(8, static_cast<int>(std::sqrt(samples)));
      while (side > 2 && (side * side * pixels > most_enlarged_pixels ||
                          side * (std::max(view.width, view.height) + 1) > most_enlarged_side))
        side /= 2;
      plan_.samples = asked > 1 ? asked : side * side;
    }
  }

  void describe() {
    const Settings& s = plan_.settings;
    plan_.description =
        fmt::format("{} in {}, {}", option_label("renderer"), choice_key<&Settings::precision>(s.precision),
                    plan_.samples > 1 ? fmt::format("the mean of {} samples over each pixel", all_samples())
                                      : "sampled as the points are");
    for (const std::string& assignment : exact_) plan_.description += ", " + assignment;
  }

  /// Rays take the samples twice, at places of two patterns.
  int all_samples() const { return sends_rays(plan_.settings.renderer) ? 2 * plan_.samples : plan_.samples; }

  std::string_view option_label(std::string_view key) const { return chosen(*find_option(key), plan_.settings).label; }

  std::span<const SweepPoint> points_;
  const SceneTraits& traits_;
  ReferencePlan plan_;
  std::vector<std::string> exact_;
  bool average_ = false;
};

}  // namespace

ReferencePlan plan_reference(std::span<const SweepPoint> points, const Settings& base, const SceneTraits& traits,
                             const View& view, const ReferenceOptions& options) {
  return Planner(points, base, traits).plan(view, options);
}

std::string truth_text(const Option& option) {
  const std::string_view exact = option.truth.exact;
  switch (option.truth.kind) {
  case TruthKind::undeclared:
    break;
  case TruthKind::as_set:
    return "the picture with the value as set";
  case TruthKind::exact:
    return fmt::format("the picture with {}", exact);
  case TruthKind::pixel_average:
    return exact.empty() ? "the mean over each pixel" : fmt::format("the mean over each pixel, with {}", exact);
  }
  return "";
}

}  // namespace ps
