#include <cmath>

#include <fmt/format.h>

#include "engine/claim.h"
#include "frame/display_frame.h"
#include "image/metrics.h"
#include "options/option.h"
#include "options/renderer_kind.h"
#include "render/render.h"

namespace ps {
namespace {

/// Renders sides of a document, and only what a metric asks for.
class Bench {
 public:
  Bench(const Document& document, Progress& progress) : document_(document), progress_(progress) {}

  Frame frame(const Settings& settings, Channel channels = Channel::none) {
    RenderRequest request;
    request.channels = channels;
    return render(document_.scene, view_of(document_), settings, request, prepared_, progress_);
  }
  Frame frame(Side side, Channel channels = Channel::none) {
    return frame(side_of(document_, side).settings, channels);
  }
  Image<Rgb8> levels(Side side) { return display_frame(frame(side), side_of(document_, side).settings); }

  Vec2i pixel() const {
    const View view = view_of(document_);
    const Vec2i p = document_.pixel;
    if (p.x < 0 || p.y < 0 || p.x >= view.width || p.y >= view.height)
      throw InputError("the claim speaks of a pixel, but none inside the picture is picked");
    return p;
  }
  double level(Side side, int channel) {
    const Rgb8 colour = levels(side).at(pixel().x, pixel().y);
    return channel == 0 ? colour.r : channel == 1 ? colour.g : colour.b;
  }
  PixelId id(Side side) { return frame(side, Channel::ids).ids.at(pixel().x, pixel().y); }

 private:
  const Document& document_;
  Progress& progress_;
  Prepared prepared_;
};

/// A's shadows against those in double precision with rays that start outside the surface's rounding error. Only pixels
/// that show the same object in both are counted.
double false_shadow_pixels(Bench& bench, const Document& document) {
  Settings exact = document.a.settings;
  exact.precision = Precision::float64;
  exact.self_hit = SelfHit::offset;
  exact.sphere_test = SphereTest::robust;
  const Channel channels = Channel::shadow | Channel::ids;
  const Frame tested = bench.frame(Side::a, channels);
  const Frame reference = bench.frame(exact, channels);
  double count = 0;
  for (int y = 0; y < tested.height(); ++y)
    for (int x = 0; x < tested.width(); ++x)
      if (tested.ids.at(x, y) == reference.ids.at(x, y) && (tested.shadow.at(x, y) & ~reference.shadow.at(x, y)) != 0)
        ++count;
  return count;
}

void reset_option(const std::string& key, Settings& settings) {
  const Option* option = find_option(key);
  PS_ASSERT(option, "the parser lets only known options through");
  option->set(settings, option->default_value());
}

bool counts_rays(Counter counter) {
  constexpr CounterSet rays{Counter::eye_rays, Counter::shadow_rays, Counter::reflection_rays,
                            Counter::refraction_rays};
  return rays.contains(counter);
}

double count_of(const Frame& frame, const Settings& settings, Counter counter) {
  if (const auto count = frame.counters.get(counter)) return static_cast<double>(*count);
  // Who draws fragments sends no ray: a claim may hold that against those who do.
  if (counts_rays(counter) && picture_way(settings.renderer) == PictureWay::fragments) return 0;
  throw InputError(fmt::format("metric: the picture's renderer does not count {}", counter_key(counter)));
}

}  // namespace

double measure(const Claim& claim, const Document& document, Progress& progress) {
  Bench bench(document, progress);
  switch (claim.metric) {
  case ClaimMetric::differing_pixels:
    return static_cast<double>(compare_channels(bench.levels(Side::a), bench.levels(Side::b)).differing);
  case ClaimMetric::mean_difference:
    return compare_channels(bench.levels(Side::a), bench.levels(Side::b)).mae;
  case ClaimMetric::max_difference:
    return compare_channels(bench.levels(Side::a), bench.levels(Side::b)).max;
  case ClaimMetric::counter_a:
    return count_of(bench.frame(Side::a), document.a.settings, claim.counter);
  case ClaimMetric::counter_b:
    return count_of(bench.frame(Side::b), document.b.settings, claim.counter);
  case ClaimMetric::false_shadow_pixels:
    return false_shadow_pixels(bench, document);
  case ClaimMetric::red_a:
    return bench.level(Side::a, 0);
  case ClaimMetric::green_a:
    return bench.level(Side::a, 1);
  case ClaimMetric::blue_a:
    return bench.level(Side::a, 2);
  case ClaimMetric::red_b:
    return bench.level(Side::b, 0);
  case ClaimMetric::green_b:
    return bench.level(Side::b, 1);
  case ClaimMetric::blue_b:
    return bench.level(Side::b, 2);
  case ClaimMetric::object_a:
    return bench.id(Side::a).object;
  case ClaimMetric::object_b:
    return bench.id(Side::b).object;
  case ClaimMetric::triangle_a:
    return bench.id(Side::a).triangle;
  case ClaimMetric::triangle_b:
    return bench.id(Side::b).triangle;
  }
  return std::nan("");
}

ClaimResult check_claim(const Claim& claim, Progress& progress) {
  const Document document = state_document(claim.state, Document{});
  ClaimResult result;
  result.value = measure(claim, document, progress);
  Document mutated = document;
  reset_option(claim.mutation, mutated.a.settings);
  reset_option(claim.mutation, mutated.b.settings);
  result.mutated_value = measure(claim, mutated, progress);
  result.holds = keeps_bound(claim, result.value);
  result.has_teeth = !keeps_bound(claim, result.mutated_value);
  return result;
}

}  // namespace ps
