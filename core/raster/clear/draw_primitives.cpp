#include "raster/clear/draw_primitives.h"

#include <algorithm>
#include <optional>

#include "raster/assembly/set_up_triangle.h"
#include "raster/base/fragment_event.h"
#include "raster/clear/canvas_items.h"
#include "raster/clear/coverage/explain.h"
#include "raster/clear/coverage/of_triangle.h"
#include "raster/clear/shade_fragment.h"
#include "raster/clear/stepping_recorder.h"
#include "record/field_recorder.h"

namespace ps::raster {
namespace {

/// Draws triangles into one tile; the members are what its steps share.
template <class Real, class Recorder>
class TriangleDrawer {
 public:
  TriangleDrawer(const RasterInputs<Real>& inputs, const ScreenGeometry<Real>& geometry, const DrawStep& step,
                 Target<Real>& target, Recorder& recorder)
      : inputs_(inputs), geometry_(geometry), step_(step), target_(target), recorder_(recorder),
        depth_buffer_(inputs.settings.visibility == Visibility::depth_buffer),
        depth_by_plane_(finds_depth_by_plane(inputs.settings)),
        sorts_translucent_(blends(inputs.settings) && inputs.settings.blending == Blending::sorted) {}

  void set_up(const PrimitiveRef& ref) {
    ref_ = ref;
    setup_ = set_up_triangle(inputs_, geometry_, ref);
  }

  void draw(const PrimitiveRef& ref) {
    set_up(ref);
    const ScreenTriangle<Real>& triangle = *setup_.triangle;
    const TileRect& rect = target_.rect();
    const TileRect box = common_part(tested_box(inputs_, triangle), rect);
    if constexpr (Recorder::one_pixel)
      if (step_.is_first() && target_.samples() == 1) report_if_missed(rect);
    if (is_empty(box)) return;
    if (target_.samples() > 1) return draw_multisampled(box);
    walk_coverage<Real>(inputs_.coverage, coverage_input(inputs_, triangle, setup_.edges), box, *this);
  }

  // The sink of coverage strategies (coverage/input.h).
  void test(int column, int row) { test_all({column, row, column + 1, row + 1}); }
  void test_all(const TileRect& box) { count_tests(Counter::coverage_tests, sample_count(box), box); }
  void region(const TileRect& box) { count_tests(Counter::coverage_regions, 1, box); }
  void cover(int column, int row) { cover(column, row, setup_.edges.at(column, row)); }
  /// A covered sample: depth test, shading, write, as far as the step goes.
  void cover(int column, int row, const std::array<std::int64_t, 3>& values) {
    recorder_.at(column, row);
    recorder_.count(Counter::fragments);
    if (target_.wants(Channel::overdraw) && step_.is_first()) ++target_.frame().overdraw.at(column, row);
    const Fragment<Real> fragment = make_fragment(inputs_, setup_, column, row, values);
    if (is_cut_out(inputs_, setup_, fragment, recorder_)) return report_cut_out(values);
    Real depth = 0;
    Real stored = 0;
    auto verdict = FragmentEvent::Depth::off;
    if (depth_buffer_) {
      count_depth_test();
      depth = inputs_.depth.encode(depth_value(inputs_, setup_, fragment, inputs_.grid.sample));
      stored = target_.depth(column, row);
      const bool passed =
          step_.is_first() ? is_nearer(inputs_.depth, depth, stored) : depth == stored && is_next(column, row);
      verdict = passed ? FragmentEvent::Depth::passed : FragmentEvent::Depth::failed;
    }
    recorder_.begin([&] { return event_of_pass(fragment, values, verdict, stored, depth); });
    if constexpr (Recorder::records)
      if (!inputs_.coverage.is_common() && step_.is_first()) recorder_.event([&] { return explain(column, row); });
    if (verdict == FragmentEvent::Depth::failed)
      recorder_.count(Counter::depth_failures);
    else
      pass_on(fragment, depth);
    recorder_.end();
  }
  void report_cut_out(const std::array<std::int64_t, 3>& values) {
    recorder_.event([&] {
      RejectEvent event = not_covered_event(inputs_, setup_, values);
      event.reason = RejectReason::cut_out;
      event.detail.clear();
      return event;
    });
  }

  /// Shades and writes what deferred shading kept of a pixel.
  void shade_winner(const Winner<Real>& winner) {
    if (!is_set_up_for(winner.triangle)) set_up(winner.triangle);
    const Fragment<Real>& fragment = winner.fragment;
    recorder_.at(fragment.column, fragment.row);
    recorder_.begin([&] {
      const Real depth = target_.depth(fragment.column, fragment.row);
      return event_of_pass(fragment, setup_.edges.at(fragment.column, fragment.row), FragmentEvent::Depth::passed,
                           depth, depth);
    });
    shade_and_write(fragment);
    recorder_.end();
  }

 private:
  bool is_set_up_for(const PrimitiveRef& ref) const {
    return setup_.triangle && ref.batch == ref_.batch && ref.index == ref_.index;
  }
  /// Of several fragments at the buffer's own depth the first is shaded, in each pass over the triangles.
  bool is_next(int column, int row) {
    const int passes = step_.stage == DrawStage::one_light ? step_.light : 0;
    return target_.times_shaded(column, row) == passes;
  }
  FragmentEvent event_of_pass(const Fragment<Real>& fragment, const std::array<std::int64_t, 3>& values,
                              FragmentEvent::Depth verdict, Real stored, Real depth) const {
    FragmentEvent event = fragment_event(inputs_, setup_, fragment, values, verdict, stored, depth);
    switch (step_.stage) {
    case DrawStage::whole:
      break;
    case DrawStage::depth_only:
    case DrawStage::keep_winners:
      event.pass = FragmentEvent::Pass::depth_first;
      break;
    case DrawStage::shade_visible:
    case DrawStage::one_light:
      event.pass = FragmentEvent::Pass::shading;
      break;
    }
    return event;
  }

  /// Everything behind a translucent surface was drawn before; its depth must not hide others that are translucent.
  bool writes_depth() const { return !(sorts_translucent_ && setup_.surface->material.passes_light()); }

  /// What becomes of a fragment that passed.
  void pass_on(const Fragment<Real>& fragment, Real depth) {
    const int column = fragment.column, row = fragment.row;
    switch (step_.stage) {
    case DrawStage::whole:
      if (depth_buffer_ && writes_depth()) target_.depth(column, row) = depth;
      return shade_and_write(fragment);
    case DrawStage::depth_only:
      target_.depth(column, row) = depth;
      return;
    case DrawStage::keep_winners:
      target_.depth(column, row) = depth;
      target_.winner(column, row) = {ref_, fragment, true};
      return;
    case DrawStage::shade_visible:
    case DrawStage::one_light:
      ++target_.times_shaded(column, row);
      return shade_and_write(fragment);
    }
  }

  void shade_and_write(const Fragment<Real>& fragment) {
    const int column = fragment.column, row = fragment.row;
    const bool one_light = step_.stage == DrawStage::one_light;
    const ShadedFragment<Real> shaded = shade_fragment(inputs_, geometry_, setup_, fragment, recorder_,
                                                       one_light ? std::optional<int>(step_.light) : std::nullopt);
    const Vec3<Real> before = target_.colour(column, row);
    const Real opacity = opacity_of(inputs_, setup_, fragment, recorder_);
    // Passes after the first light's add to the picture.
    const Vec3<Real> after =
        one_light && step_.light > 0 ? before + shaded.colour : blend_over(shaded.colour, before, opacity);
    report_write(before, shaded.colour, after, opacity);
    recorder_.count(Counter::pixels_written);
    target_.set_colour(column, row, after);
    if (inputs_.channels != Channel::none) write_channels(fragment, shaded);
  }

  void report_write(const Vec3<Real>& before, const Vec3<Real>& shaded, const Vec3<Real>& after, Real opacity) {
    recorder_.event([&] {
      return WriteEvent{event_id(setup_), Vec3d(before), Vec3d(shaded), Vec3d(after), static_cast<double>(opacity)};
    });
  }

  /// Multisampling: coverage and depth for each sub-sample, one shade for the pixel, at its centre.
  void draw_multisampled(const TileRect& box) {
    const SubSampleEdges sub = make_sub_sample_edges(setup_.edges, inputs_.grid.subpixel_bits);
    for (int row = box.y0; row < box.y1; ++row)
      for (int column = box.x0; column < box.x1; ++column) cover_samples(sub, column, row);
  }
  void cover_samples(const SubSampleEdges& sub, int column, int row) {
    recorder_.at(column, row);
    const auto pattern = sample_pattern(inputs_.grid.samples);
    const auto middle = setup_.edges.at(column, row);
    count_tests(Counter::coverage_tests, pattern.size(), {column, row, column + 1, row + 1});
    const Fragment<Real> fragment = make_fragment(inputs_, setup_, column, row, middle);
    std::array<bool, 8> visible{};
    int covered = 0;
    for (std::size_t s = 0; s < pattern.size(); ++s) covered += visible[s] = sub.inside(sub.at(middle, pattern[s]));
    if (covered == 0) {
      if constexpr (Recorder::records) recorder_.event([&] { return not_covered_event(inputs_, setup_, middle); });
      return;
    }
    if (is_cut_out(inputs_, setup_, fragment, recorder_)) return report_cut_out(middle);
    int passed = 0;
    std::optional<Real> first_stored, first_depth;
    for (std::size_t s = 0; s < pattern.size(); ++s) {
      if (!visible[s]) continue;
      if (depth_buffer_) {
        count_depth_test();
        const auto at_sample = sub_sample_fragment(inputs_, setup_, sub, column, row, sub.at(middle, pattern[s]));
        const Real depth = inputs_.depth.encode(
            depth_value(inputs_, setup_, at_sample, place_in_pixel(pattern[s], inputs_.grid.sample)));
        Real& stored = target_.sample_depth(column, row, static_cast<int>(s));
        if (!first_depth) first_stored = stored, first_depth = depth;
        visible[s] = is_nearer(inputs_.depth, depth, stored);
        if (visible[s] && writes_depth()) stored = depth;
      }
      passed += visible[s];
    }
    recorder_.count(Counter::fragments);
    recorder_.count(Counter::subsamples, static_cast<std::uint64_t>(covered));
    recorder_.count(Counter::depth_failures, static_cast<std::uint64_t>(covered - passed));
    if (target_.wants(Channel::overdraw)) ++target_.frame().overdraw.at(column, row);
    recorder_.begin([&] {
      const auto verdict = !depth_buffer_ ? FragmentEvent::Depth::off
                           : passed > 0   ? FragmentEvent::Depth::passed
                                          : FragmentEvent::Depth::failed;
      FragmentEvent event =
          fragment_event(inputs_, setup_, fragment, middle, verdict, first_stored.value_or(0), first_depth.value_or(0));
      event.samples = inputs_.grid.samples;
      event.samples_covered = covered;
      return event;
    });
    if (passed > 0) write_samples(fragment, visible);
    recorder_.end();
  }
  void write_samples(const Fragment<Real>& fragment, const std::array<bool, 8>& visible) {
    const ShadedFragment<Real> shaded = shade_fragment(inputs_, geometry_, setup_, fragment, recorder_);
    const Real opacity = opacity_of(inputs_, setup_, fragment, recorder_);
    Vec3<Real> before = target_.sample_colour(fragment.column, fragment.row, 0), after = shaded.colour;
    for (int s = inputs_.grid.samples - 1; s >= 0; --s) {
      if (!visible[static_cast<std::size_t>(s)]) continue;
      Vec3<Real>& stored = target_.sample_colour(fragment.column, fragment.row, s);
      if (opacity != Real(1)) before = stored;  // of the first sample that is blended, in the end
      after = stored = blend_over(shaded.colour, stored, opacity);
    }
    recorder_.event([&] { return written_samples(visible); });
    report_write(before, shaded.colour, after, opacity);
    recorder_.count(Counter::pixels_written);
    if (inputs_.channels != Channel::none && visible[0]) write_channels(fragment, shaded);
  }

  /// Which of the pixel's samples get the colour, for the inspector: their numbers are the event's values.
  CoverageEvent written_samples(const std::array<bool, 8>& visible) const {
    CoverageEvent event;
    event.id = event_id(setup_);
    event.strategy = inputs_.coverage.strategy;
    event.covered = true;
    event.tests = inputs_.grid.samples;
    for (int s = 0; s < inputs_.grid.samples; ++s)
      if (visible[static_cast<std::size_t>(s)]) event.values.push_back(s);
    event.how = std::to_string(event.values.size()) + " of " + std::to_string(event.tests) + " samples are written";
    return event;
  }

  /// A test, and what is interpolated for it.
  void count_depth_test() {
    recorder_.count(Counter::depth_tests);
    if (!depth_by_plane_) recorder_.count(Counter::attributes_interpolated);
  }
  static std::uint64_t sample_count(const TileRect& box) {
    return static_cast<std::uint64_t>(box.x1 - box.x0) * static_cast<std::uint64_t>(box.y1 - box.y0);
  }
  /// Counts, and in the channel adds one test to each pixel that was decided about.
  void count_tests(Counter counter, std::uint64_t tests, const TileRect& box) {
    recorder_.count(counter, tests);
    if (!target_.wants(Channel::tests)) return;
    for (int row = box.y0; row < box.y1; ++row)
      for (int column = box.x0; column < box.x1; ++column) ++target_.frame().tests.at(column, row);
  }

  void write_channels(const Fragment<Real>& fragment, const ShadedFragment<Real>& shaded) {
    const int x = fragment.column;
    const int y = fragment.row;
    const bool sphere = setup_.surface->sphere;
    Frame& frame = target_.frame();
    if (target_.wants(Channel::depth)) frame.depth.at(x, y) = static_cast<float>(fragment.z);
    if (target_.wants(Channel::normal)) frame.normal.at(x, y) = Vec3f(shaded.normal);
    if (target_.wants(Channel::barycentric))
      frame.barycentric.at(x, y) =
          sphere ? Vec3f(0) : Vec3f(whole_weights(setup_, space_weights(inputs_, setup_, fragment)));
    if (target_.wants(Channel::uv)) frame.uv.at(x, y) = Vec2f(shaded.uv);
    if (target_.wants(Channel::ids)) frame.ids.at(x, y) = shown_id(setup_);
    if (target_.wants(Channel::facing)) frame.facing.at(x, y) = facing(x, y);
    if (target_.wants(Channel::shadow)) {
      const bool further_light = step_.stage == DrawStage::one_light && step_.light > 0;
      frame.shadow.at(x, y) = shaded.shadow_mask | (further_light ? frame.shadow.at(x, y) : 0u);
    }
    if (target_.wants(Channel::mip)) frame.mip.at(x, y) = static_cast<float>(shaded.mip);
  }

  /// Cosine between the triangle's normal and the direction to the eye.
  float facing(int column, int row) const {
    const Vec2d v = inputs_.viewport.at(column, row);
    Vec3d ray = inputs_.camera.forward;
    if (inputs_.perspective())
      ray = inputs_.camera.right * v.x + inputs_.camera.up * v.y + inputs_.camera.forward * inputs_.viewport.distance;
    return static_cast<float>(-dot(ray, Vec3d(setup_.triangle->face_normal)) / std::sqrt(dot(ray, ray)));
  }

  /// An inspected tile is a single pixel: reports a triangle that comes near it without covering it.
  void report_if_missed(const TileRect& rect) {
    const CoverageEvent decision = explain(rect.x0, rect.y0);
    if (decision.covered) return;
    recorder_.event([&] {
      RejectEvent event = not_covered_event(inputs_, setup_, setup_.edges.at(rect.x0, rect.y0));
      if (!inputs_.coverage.is_common()) event.detail = decision.how;
      return event;
    });
  }
  CoverageEvent explain(int column, int row) const {
    CoverageEvent event =
        explain_coverage<Real>(inputs_.coverage, coverage_input(inputs_, *setup_.triangle, setup_.edges), column, row);
    event.id = event_id(setup_);
    return event;
  }

  const RasterInputs<Real>& inputs_;
  const ScreenGeometry<Real>& geometry_;
  DrawStep step_;
  Target<Real>& target_;
  Recorder& recorder_;
  bool depth_buffer_, depth_by_plane_, sorts_translucent_;
  PrimitiveRef ref_;
  TriangleSetup<Real> setup_;
};

}  // namespace

template <class Real, class Recorder>
void draw_primitives(const RasterInputs<Real>& inputs, const ScreenGeometry<Real>& geometry,
                     std::span<const PrimitiveRef> primitives, const DrawStep& step, Target<Real>& target,
                     Recorder& recorder) {
  TriangleDrawer<Real, Recorder> triangles(inputs, geometry, step, target, recorder);
  for (const PrimitiveRef& ref : primitives)
    if (ref.is_line())
      draw_edge(inputs, geometry.batches[ref.batch].lines[ref.index], target, recorder);
    else
      triangles.draw(ref);
}

template <class Real, class Recorder>
void shade_winners(const RasterInputs<Real>& inputs, const ScreenGeometry<Real>& geometry, Target<Real>& target,
                   Recorder& recorder) {
  TriangleDrawer<Real, Recorder> triangles(inputs, geometry, {DrawStage::shade_visible, 0}, target, recorder);
  const TileRect& rect = target.rect();
  for (int row = rect.y0; row < rect.y1; ++row)
    for (int column = rect.x0; column < rect.x1; ++column)
      if (const Winner<Real>& winner = target.winner(column, row); winner.any) triangles.shade_winner(winner);
}

// NOLINTBEGIN(bugprone-macro-parentheses): Real and Recorder are types
#define PS_INSTANTIATE(Real, Recorder)                                                                                 \
  template void draw_primitives(const RasterInputs<Real>&, const ScreenGeometry<Real>&, std::span<const PrimitiveRef>, \
                                const DrawStep&, Target<Real>&, Recorder&);                                            \
  template void shade_winners(const RasterInputs<Real>&, const ScreenGeometry<Real>&, Target<Real>&, Recorder&);
PS_INSTANTIATE(float, CountingRecorder)
PS_INSTANTIATE(float, PixelRecorder)
PS_INSTANTIATE(double, CountingRecorder)
PS_INSTANTIATE(double, PixelRecorder)
PS_INSTANTIATE(float, SteppingRecorder)
PS_INSTANTIATE(double, SteppingRecorder)
PS_INSTANTIATE(float, FieldRecorder)
PS_INSTANTIATE(double, FieldRecorder)
#undef PS_INSTANTIATE
// NOLINTEND(bugprone-macro-parentheses)

}  // namespace ps::raster
