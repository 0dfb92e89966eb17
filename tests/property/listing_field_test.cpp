// A value of a listing's line, shown for every pixel, is the one that a trace of each pixel has. The oracle reads
// traces by code of its own: it gathers the works for the pixel, takes the one with the most values of its own (of
// equals the last) and counts there.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "options/option.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/seeded_random.h"
#include "textbook/listing_field.h"

namespace ps::listing_field_test {
namespace {

/// The loops around a watch, the innermost first, up to the work for a pixel, whose index ends them; empty: in none.
std::vector<int> loops_to_work(const ListingTrace& trace, int instance) {
  std::vector<int> loops;
  for (; instance >= 0; instance = trace.instances[static_cast<std::size_t>(instance)].parent) {
    loops.push_back(instance);
    if (trace.instances[static_cast<std::size_t>(instance)].name == "pixel") return loops;
  }
  return {};
}

/// The number of the n-th watch that is like this one, in the work that the view shows first.
double number_like(const ListingTrace& trace, const Watch& like, const std::string& loop, int order) {
  std::vector<int> own(trace.instances.size(), 0);
  for (const Watch& watch : trace.watches)
    if (watch.instance >= 0) ++own[static_cast<std::size_t>(watch.instance)];
  int shown = -1;
  for (std::size_t i = 0; i < own.size(); ++i)
    if (trace.instances[i].name == "pixel" && (shown < 0 || own[i] >= own[static_cast<std::size_t>(shown)]))
      shown = static_cast<int>(i);
  for (const Watch& watch : trace.watches) {
    const std::vector<int> loops = loops_to_work(trace, watch.instance);
    if (loops.empty() || loops.back() != shown || watch.line != like.line || watch.name != like.name) continue;
    const WatchInstance& inner = trace.instances[static_cast<std::size_t>(loops.front())];
    if ((loops.size() > 1 ? std::string(inner.name) + watch_text(inner.value) : std::string()) != loop) continue;
    if (order-- > 0) continue;
    if (const auto* number = std::get_if<double>(&watch.value)) return *number;
    if (const auto* whole = std::get_if<std::int64_t>(&watch.value)) return static_cast<double>(*whole);
    if (const auto* truth = std::get_if<bool>(&watch.value)) return *truth ? 1 : 0;
    if (const auto* pair = std::get_if<Vec2d>(&watch.value)) return std::hypot(pair->x, pair->y);
    if (const auto* three = std::get_if<Vec3d>(&watch.value)) return std::hypot(three->x, three->y, three->z);
  }
  return std::nan("");
}

struct Case {
  const char* scene;
  std::string listing;
};

void expect_as_in_traces(const Case& one, std::mt19937& random) {
  SCOPED_TRACE(one.scene + (" " + one.listing));
  const Scene scene = load_scene(one.scene);
  Settings settings = settings_for(scene);
  parse_assignment("renderer=textbook", settings);
  parse_assignment("listing=" + one.listing, settings);
  const View view{scene.camera, 30, 24};
  const auto pick = [&](std::size_t below) { return std::uniform_int_distribution<std::size_t>(0, below - 1)(random); };
  const auto trace_at = [&](Vec2i pixel) {
    return trace_listing(scene, view, settings, pixel, nullptr, TracedTriangles::all);
  };
  int asked = 0;
  for (int attempt = 0; attempt < 600 && asked < 4; ++attempt) {
    const Vec2i pixel(static_cast<int>(pick(30)), static_cast<int>(pick(24)));
    const ListingTrace trace = trace_at(pixel);
    if (trace.watches.empty()) continue;
    const std::size_t chosen = pick(trace.watches.size());
    const auto query = listing_query(trace, chosen);
    const std::vector<int> loops = loops_to_work(trace, trace.watches[chosen].instance);
    ASSERT_FALSE(query && loops.empty());
    if (!query) continue;
    ++asked;
    EXPECT_EQ(parse_field_query(field_query_text(*query)), *query);
    const WatchInstance& inner = trace.instances[static_cast<std::size_t>(loops.front())];
    const std::string loop = loops.size() > 1 ? std::string(inner.name) + watch_text(inner.value) : std::string();
    RenderRequest request;
    request.channels = Channel::field;
    request.field = std::make_shared<const ShownField>(ShownField{*query, {}});
    Prepared prepared;
    Progress progress;
    const Frame frame = render(scene, view, settings, request, prepared, progress);
    for (int y = 0; y < view.height; y += 3)
      for (int x = 0; x < view.width; x += 2) {
        const double expected = number_like(trace_at({x, y}), trace.watches[chosen], loop, query->order);
        const float found = frame.field.at(x, y);
        if (std::isnan(expected))
          EXPECT_TRUE(std::isnan(found)) << field_query_text(*query) << " at " << x << ", " << y;
        else
          EXPECT_FLOAT_EQ(found, static_cast<float>(expected)) << field_query_text(*query) << " at " << x << ", " << y;
      }
  }
  EXPECT_GT(asked, 0);
}

TEST(ListingField, IsTheNumberOfEveryTrace) {
  test::SeededRandom random;
  for (const Case& one :
       {Case{"cgfs/spheres", "cgfs-02-basic-ray-tracing"}, Case{"cgfs/reflections", "cgfs-04-shadows-and-reflections"},
        Case{"cgfs/cubes", "cgfs-11-clipping"}, Case{"cgfs/cubes", "cgfs-10-scenes"},
        Case{"cgfs/depth", "cgfs-12-hidden-surfaces"}, Case{"cgfs/shading", "cgfs-13-shading"}})
    expect_as_in_traces(one, random);
}

TEST(ListingField, OnlyTheRendererThatHasItShowsIt) {
  const FieldQuery line = parse_field_query("listing-line 28 sphere red: N . L");
  EXPECT_EQ(line.key, "N . L");
  EXPECT_EQ(field_query_words(line), "N . L in the listing, sphere red");
  EXPECT_TRUE(no_field_reason(Renderer::textbook, line).empty());
  EXPECT_FALSE(no_field_reason(Renderer::ray_tracer, line).empty());
  EXPECT_FALSE(no_field_reason(Renderer::textbook, parse_field_query("hit: t")).empty());
  EXPECT_TRUE(no_field_reason(Renderer::ray_tracer, parse_field_query("hit: t")).empty());
}

}  // namespace
}  // namespace ps::listing_field_test
