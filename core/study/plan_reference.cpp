#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/check.h"
#include "options/choice_key.h"
#include "options/renderer_kind.h"
#include "options/robust_rays.h"
#include "study/reference.h"
#include "study/view_pixels.h"

namespace ps {
namespace {

constexpr int ordinary_samples = 64, fewest_averaged = 4, most_samples = 4096;
/// Fragments are averaged over a larger picture, which has at most this many pixels: about 1.2 GB in double.
constexpr double most_enlarged_pixels = 0x1p25;
constexpr int most_enlarged_side = 16384;
/// Rays of one picture: more samples than a study needs are taken up to this number, which takes some seconds.
constexpr double most_rays = 3e7;
/// Rays in double are scalar; beyond this many of them, float with SIMD takes their place.
constexpr double most_double_rays = 0x1p24;
constexpr int counted_part = 8, least_counted = 32;  ///< the small picture in which they are counted, of the sides

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

/// Can rays show what the settings ask for? Neither canvas items alone nor the rasterizer's outlines.
bool shown_by_rays(const Settings& settings, const SceneTraits& traits) {
  const bool only_canvas = traits.canvas_items && !traits.spheres && !traits.triangles && !traits.solids && !traits.csg;
  const bool outlines = draws_fragments(settings.renderer) && settings.draw != Draw::filled;
  return !only_canvas && !outlines;
}

/// Rays take the samples twice, at places of two patterns.
int all_samples(const ReferencePlan& plan) {
  return sends_rays(plan.settings.renderer) ? 2 * plan.samples : plan.samples;
}

/// Brings the rays of an average down to what a study can wait for; `rays` is the number of one sample.
void limit_rays(ReferencePlan& plan, const View& view, double rays) {
  const auto all = [&] { return rays * all_samples(plan) * pixels_of(view); };
  while (plan.samples > plan.fewest_samples && all() > most_rays) plan.samples /= 4;
  const bool precision_counts = std::any_of(plan.swept.begin(), plan.swept.end(),
                                            [](const Option* option) { return option->key == "precision"; });
  if (!precision_counts && all() > most_double_rays) plan.settings.precision = Precision::float32;
}

/// The rays that leave the eye, a surface or a light for one sample of a pixel, counted in a small picture.
double rays_of_a_sample(const Settings& settings, const Scene& scene, const View& view, const RenderRequest& how,
                        Prepared& prepared, Progress& progress) {
  View small = view;
  small.width = std::max(std::min(view.width, least_counted), view.width / counted_part);
  small.height = std::max(std::min(view.height, least_counted), view.height / counted_part);
  Settings quick = settings;
  quick.precision = Precision::float32;
  const Counters counters = render(scene, small, quick, how, prepared, progress).counters;
  std::uint64_t rays = 0;
  for (const Counter counter :
       {Counter::eye_rays, Counter::shadow_rays, Counter::reflection_rays, Counter::refraction_rays})
    rays += counters.get(counter).value_or(0);
  return static_cast<double>(rays) / pixels_of(small);
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
      if (differs(option, points)) {
        option.set(plan_.settings, option.get(base));
        plan_.swept.push_back(&option);
      }
  }

  ReferencePlan plan(const View& view, const ReferenceOptions& options) {
    for (const Option* option : plan_.swept) take(*option);
    be_robust();
    // Lines and outlines cover no area whose mean could be taken.
    average_ = average_ && shown_by_rays(plan_.settings, traits_);
    if (options.samples > 1 || (options.samples == 0 && average_)) take_average(view, options.samples);
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
      std::vector<std::string>& exact = plan_.exact;
      if (std::find(exact.begin(), exact.end(), assignment) == exact.end()) exact.push_back(assignment);
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
    int fewest = fewest_averaged;
    while (fewest < 4 * most && fewest < most_samples) fewest *= 4;
    const int samples = std::max(fewest, ordinary_samples);
    Settings& s = plan_.settings;
    s.samples_per_pixel = 1;
    s.sample_pattern = SamplePattern::grid;
    s.adaptive_sampling = false;
    s.subsampling = 1;
    s.multisampling = 1;
    const double pixels = pixels_of(view);
    if (sends_rays(s.renderer)) {
      plan_.samples = asked > 1 ? asked : samples;
      plan_.fewest_samples = asked > 1 ? asked : fewest;
      limit_rays(plan_, view, 1);
    } else {
      // A texture's footprint is known to no sample: more of them are needed than for edges.
      int side = std::max(8, static_cast<int>(std::sqrt(samples)));
      while (side > 2 && (side * side * pixels > most_enlarged_pixels ||
                          side * (std::max(view.width, view.height) + 1) > most_enlarged_side))
        side /= 2;
      plan_.samples = asked > 1 ? asked : side * side;
    }
  }

  std::span<const SweepPoint> points_;
  const SceneTraits& traits_;
  ReferencePlan plan_;
  bool average_ = false;
};

}  // namespace

std::string ReferencePlan::description() const {
  std::string text = fmt::format("{} in {}, {}", renderer_label(settings.renderer),
                                 choice_key<&Settings::precision>(settings.precision),
                                 samples > 1 ? fmt::format("the mean of {} samples over each pixel", all_samples(*this))
                                             : "sampled as the points are");
  for (const std::string& assignment : exact) text += ", " + assignment;
  return text;
}

ReferencePlan plan_reference(std::span<const SweepPoint> points, const Settings& base, const SceneTraits& traits,
                             const View& view, const ReferenceOptions& options) {
  return Planner(points, base, traits).plan(view, options);
}

ReferencePlan affordable(ReferencePlan plan, const Scene& scene, const View& view, const RenderRequest& how,
                         Prepared& prepared, Progress& progress) {
  if (plan.samples > 1 && sends_rays(plan.settings.renderer))
    limit_rays(plan, view, rays_of_a_sample(plan.settings, scene, view, how, prepared, progress));
  return plan;
}

std::string truth_text(const Option& option) {
  const std::string_view exact = option.truth.exact;
  switch (option.truth.kind) {
  case TruthKind::undeclared:
    break;
  case TruthKind::as_set:
    return "the picture with the value as set";
  case TruthKind::other_picture:
    return "none: each value shows another picture on purpose";
  case TruthKind::exact:
    return fmt::format("the picture with {}", exact);
  case TruthKind::pixel_average:
    return exact.empty() ? "the mean over each pixel" : fmt::format("the mean over each pixel, with {}", exact);
  }
  return "";
}

}  // namespace ps
