// Each metric of lessons against a value found in another way: by hand from the rendered pictures, from a story, or
// from how many rays a picture needs.
#include "engine/metric.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/claim.h"
#include "engine/lesson.h"
#include "engine/metric_words.h"
#include "frame/display_frame.h"
#include "image/metrics.h"
#include "study/stability/experiment.h"
#include "support/render_once.h"

namespace ps::lesson_metric_test {
namespace {

/// A with shadows, B without.
Document shadows() {
  LessonState state;
  state.scene = "cgfs/shadows";
  state.set_a = {"renderer=ray-tracer"};
  state.set_b = {"renderer=ray-tracer", "shadows=none"};
  state.parts = {{"size", "60x50"}, {"pixel", "20,40"}};
  return state_document(state, Document{});
}

Frame rendered(const Document& document, Side side) {
  return render(document.scene, view_of(document), side_of(document, side).settings, RenderRequest{});
}

Image<Rgb8> levels(const Document& document, Side side) {
  return display_frame(rendered(document, side), side_of(document, side).settings);
}

double value_of(const std::string& metric, const Document& document, std::optional<TileRect> within = {}) {
  Metric read = parse_metric(metric);
  read.within = within;
  Progress progress;
  return measure(read, document, progress);
}

/// Differences of all channels of A and B in a rectangle.
struct Differences {
  double differing = 0, sum = 0, squares = 0, largest = 0, count = 0;
};
Differences differences(const Document& document, const TileRect& in) {
  const Image<Rgb8> a = levels(document, Side::a), b = levels(document, Side::b);
  Differences found;
  for (int y = in.y0; y < in.y1; ++y)
    for (int x = in.x0; x < in.x1; ++x) {
      const Rgb8 p = a.at(x, y), q = b.at(x, y);
      found.differing += p == q ? 0 : 1;
      for (const double apart : {double(p.r) - q.r, double(p.g) - q.g, double(p.b) - q.b}) {
        found.sum += std::abs(apart);
        found.squares += apart * apart;
        found.largest = std::max(found.largest, std::abs(apart));
        found.count += 1;
      }
    }
  return found;
}

TEST(LessonMetric, DifferencesAreThoseOfThePictures) {
  const Document document = shadows();
  for (const TileRect& in : {TileRect{0, 0, 60, 50}, TileRect{10, 30, 40, 50}}) {
    const Differences by_hand = differences(document, in);
    ASSERT_GT(by_hand.differing, 20);
    EXPECT_EQ(value_of("differing-pixels", document, in), by_hand.differing);
    EXPECT_NEAR(value_of("mean-difference", document, in), by_hand.sum / by_hand.count, 1e-9);
    EXPECT_EQ(value_of("max-difference", document, in), by_hand.largest);
    EXPECT_NEAR(value_of("psnr", document, in), 10 * std::log10(255.0 * 255.0 * by_hand.count / by_hand.squares), 1e-6);
  }
}

TEST(LessonMetric, EqualPicturesHaveNoDifference) {
  Document document = shadows();
  document.b = document.a;
  EXPECT_EQ(value_of("differing-pixels", document), 0);
  EXPECT_EQ(value_of("flip", document), 0);
  EXPECT_TRUE(std::isinf(value_of("psnr", document)));
}

TEST(LessonMetric, FlipIsThatOfTheTwoPictures) {
  const Document document = shadows();
  const double flip = value_of("flip", document);
  EXPECT_GT(flip, 0);
  EXPECT_LE(flip, 1);
  EXPECT_EQ(flip, compare_images(levels(document, Side::a), levels(document, Side::b)).flip);
}

TEST(LessonMetric, CountersAreThoseOfThePictures) {
  Document document = shadows();
  EXPECT_EQ(value_of("counter-a eye-rays", document), 60 * 50);  // one through each pixel
  EXPECT_EQ(value_of("counter-b shadow-rays", document), 0);
  EXPECT_EQ(value_of("counter-a shadow-rays", document),
            static_cast<double>(*rendered(document, Side::a).counters.get(Counter::shadow_rays)));
  document.a.settings.samples_per_pixel = 4;
  EXPECT_EQ(value_of("counter-ratio eye-rays", document), 4);
  document.b.settings.renderer = Renderer::rasterizer;
  EXPECT_EQ(value_of("counter-b eye-rays", document), 0);
  EXPECT_THROW(value_of("counter-b sphere-tests", document), InputError);
}

TEST(LessonMetric, LevelsAreThoseOfThePickedPixelOrTheirMean) {
  const Document document = shadows();
  const Image<Rgb8> a = levels(document, Side::a), b = levels(document, Side::b);
  EXPECT_EQ(value_of("red-a", document), a.at(20, 40).r);
  EXPECT_EQ(value_of("green-a", document), a.at(20, 40).g);
  EXPECT_EQ(value_of("blue-a", document), a.at(20, 40).b);
  EXPECT_EQ(value_of("red-b", document), b.at(20, 40).r);
  EXPECT_EQ(value_of("green-b", document), b.at(20, 40).g);
  EXPECT_EQ(value_of("blue-b", document), b.at(20, 40).b);
  const double mean = (a.at(3, 45).b + a.at(4, 45).b + a.at(3, 46).b + a.at(4, 46).b) / 4.0;
  EXPECT_NEAR(value_of("blue-a", document, TileRect{3, 45, 5, 47}), mean, 1e-9);
}

TEST(LessonMetric, ObjectsAreThoseOfTheStory) {
  Document document = shadows();
  for (const Vec2i pixel : {Vec2i{30, 35}, Vec2i{45, 25}, Vec2i{30, 0}}) {
    document.pixel = pixel;
    const PixelStory story = inspect(document.scene, view_of(document), document.a.settings, pixel);
    const int winner = winner_of(story);
    EXPECT_EQ(value_of("object-a", document), winner);
    const std::string name =
        winner < 0 ? "background" : document.scene.geometry->objects.at(static_cast<std::size_t>(winner)).name;
    EXPECT_EQ(value_of("winner-a " + name, document), 1) << name;
    EXPECT_EQ(value_of("winner-b " + name, document), 1) << name;
    EXPECT_EQ(value_of(winner < 0 ? "winner-a red" : "winner-a background", document), 0);
  }
  EXPECT_THROW(value_of("winner-a teapot", document), InputError);
}

TEST(LessonMetric, TrianglesAreThoseOfTheStory) {
  LessonState state;
  state.scene = "cgfs/cubes";
  state.set_a = state.set_b = {"renderer=rasterizer"};
  state.parts = {{"size", "60x60"}, {"pixel", "20,30"}};
  const Document document = state_document(state, Document{});
  const Frame frame = render(document.scene, view_of(document), document.b.settings, request_for(Channel::ids));
  EXPECT_EQ(value_of("triangle-b", document), frame.ids.at(20, 30).triangle);
  EXPECT_EQ(value_of("triangle-a", document), frame.ids.at(20, 30).triangle);
}

TEST(LessonMetric, FalseShadowsAreThoseOfASurfaceOnItself) {
  Document document = shadows();
  document.a.settings.precision = Precision::float64;
  document.a.settings.self_hit = SelfHit::offset;
  document.a.settings.sphere_test = SphereTest::robust;
  EXPECT_EQ(value_of("false-shadow-pixels", document), 0);
  document.a.settings.precision = Precision::float32;
  document.a.settings.self_hit = SelfHit::epsilon;
  document.a.settings.shadow_epsilon = 0;
  EXPECT_GT(value_of("false-shadow-pixels", document), 100);
}

TEST(LessonMetric, AnExperimentsPointIsThatOfItsCurve) {
  const std::string key = "refraction-total-internal";
  Progress progress;
  StabilityRun run;
  run.progress = &progress;
  const auto rows = find_stability_experiment(key).measure(run);
  ASSERT_FALSE(rows.empty());
  const StabilityRow& row = rows.back();
  const std::string of = std::isnan(row.naive) ? "robust" : "naive";
  const double expected = std::isnan(row.naive) ? row.robust : row.naive;
  const std::string knob =
      metric_text(parse_metric("experiment " + key + " " + of + " " + std::to_string(row.knob) + " " + row.series));
  EXPECT_EQ(value_of(knob, Document{}), expected);
  EXPECT_THROW(value_of("experiment " + key + " naive -12345 " + row.series, Document{}), InputError);
}

TEST(LessonMetric, TextsReadBack) {
  for (const std::string text : {"differing-pixels", "psnr", "flip", "counter-ratio sphere-tests",
                                 "winner-b red sphere", "experiment bvh-holes naive 0.5 holes of the tree"}) {
    EXPECT_EQ(metric_text(parse_metric(text)), text);
    EXPECT_FALSE(metric_words(parse_metric(text)).empty());
  }
  for (const char* wrong : {"", "pixels", "counter-a", "counter-a rays", "winner-a", "psnr a", "experiment",
                            "experiment bvh-holes", "experiment bvh-holes both 1 x", "experiment bvh-holes naive x y"})
    EXPECT_THROW(parse_metric(wrong), InputError) << wrong;
}

TEST(LessonMetric, ARectangleOutsideThePictureIsRefused) {
  EXPECT_THROW(value_of("red-a", shadows(), TileRect{50, 40, 70, 50}), InputError);
  Document nothing_picked = shadows();
  nothing_picked.pixel = {-1, -1};
  EXPECT_THROW(value_of("red-a", nothing_picked), InputError);
}

TEST(LessonMetric, MeasuredNumbersAreReadable) {
  EXPECT_EQ(measured_text(41231), "41,231");
  EXPECT_EQ(measured_text(1234567), "1,234,567");
  EXPECT_EQ(measured_text(-1000), "-1,000");
  EXPECT_EQ(measured_text(999), "999");
  EXPECT_EQ(measured_text(0), "0");
  EXPECT_EQ(measured_text(-0.0), "0");
  EXPECT_EQ(measured_text(0.123456), "0.1235");
  EXPECT_EQ(bound_words(parse_bound(">= 100000")), "at least 100,000");
  EXPECT_EQ(bound_words(parse_bound("<= 3")), "at most 3");
  EXPECT_EQ(bound_words(parse_bound("= 0.5 +- 0.1")), "0.5 ± 0.1");
}

TEST(LessonMetric, AWinnerIsMeasuredAsYesOrNo) {
  const Metric winner = parse_metric("winner-a red sphere"), level = parse_metric("red-a");
  EXPECT_EQ(metric_words(winner), "A's picked pixel shows red sphere");
  EXPECT_EQ(value_words(winner, 1), "yes");
  EXPECT_EQ(value_words(winner, 0), "no");
  EXPECT_EQ(value_words(level, 1), "1");
  EXPECT_EQ(demand_words(winner, parse_bound("= 1")), "yes");
  EXPECT_EQ(demand_words(winner, parse_bound("= 0")), "no");
  EXPECT_EQ(demand_words(level, parse_bound(">= 1")), "at least 1");
}

/// The claim of a step with these lines and this mutation.
Claim claim_with(const std::string& lines) {
  return parse_lesson("# T\nsource: s\n\n## One\n\n```settings\nscene cgfs/shadows\nset-both renderer=ray-tracer\n"
                      "set-b shadows=none\nsize 60x50\npixel 20,40\n```\n\n```claim\ntext It differs.\n" +
                          lines + "```\n",
                      "demo", "lesson.md")
      .steps.at(0)
      .claims.at(0);
}

TEST(LessonMutation, EachKindBreaksTheClaim) {
  struct Case {
    std::string lines, words;
  };
  for (const Case& each :
       {Case{"mutation shadows\n", "default shadows"}, Case{"mutation set-b shadows=traced\n", "set-b shadows=traced"},
        Case{"mutation scene cgfs/spheres\n", "scene cgfs/spheres"},
        Case{"mutation metric counter-b shadow-rays\n", "metric counter-b shadow-rays"},
        Case{"mutation set exposure=0.001\nmutation set-b exposure=0.001\n",
             "set exposure=0.001; set-b exposure=0.001"}}) {
    const Claim claim = claim_with("metric differing-pixels\nbound >= 20\n" + each.lines);
    EXPECT_EQ(claim.mutation.text, each.words);
    Progress progress;
    const ClaimResult result = check_claim(claim, progress);
    EXPECT_TRUE(result.holds) << each.words;
    EXPECT_TRUE(result.has_teeth) << each.words << ": " << result.mutated_value;
    EXPECT_TRUE(result.passed());
  }
}

TEST(LessonMutation, ALightMovedByAnEditBreaksTheClaim) {
  const Claim claim = claim_with("metric differing-pixels\nbound >= 20\nmutation edit light.1.intensity 0\n"
                                 "mutation edit light.2.intensity 0\n");
  Progress progress;
  EXPECT_TRUE(check_claim(claim, progress).passed());
}

TEST(LessonMutation, WhatChangesNothingHasNoTeeth) {
  const Claim claim = claim_with("metric differing-pixels\nbound >= 20\nmutation shadow-epsilon\n");
  Progress progress;
  const ClaimResult result = check_claim(claim, progress);
  EXPECT_TRUE(result.holds);
  EXPECT_FALSE(result.has_teeth);
  EXPECT_FALSE(result.passed());
}

}  // namespace
}  // namespace ps::lesson_metric_test
