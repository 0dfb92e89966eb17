// The microscope: an enlarged pixel against the picture itself, its fragments against the pixel's story and closed
// forms.
#include "inspect/microscope/microscope.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "inspect/microscope/drawing.h"
#include "inspect/microscope/enlarge.h"
#include "inspect/microscope/micro_svg.h"
#include "inspect/microscope/window_clip.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "support/render_once.h"

namespace ps::microscope_test {
namespace {

struct Bench {
  Scene scene;
  View view;
  Settings settings;
  Prepared prepared;
  Progress progress;

  explicit Bench(const std::string& name, Renderer renderer, int size = 200) : scene(load_scene(name)) {
    view = {scene.camera, size, size};
    settings.renderer = renderer;
    settings.precision = Precision::float64;
  }
  PixelStory story(Vec2i pixel) { return inspect(scene, view, settings, pixel, prepared, progress); }
};

// A ray through the middle of a pixel, made through the enlarged view, is the pixel's own ray: it must meet the same
// triangle at the same place.
TEST(Microscope, RayThroughTheMiddleIsThePixelsOwn) {
  const unsigned seed = 5;
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> any(0, 199);
  for (const char* name : {"cgfs/reflections", "cgfs/camera", "cgfs/crates"})
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
      Bench setup(name, Renderer::ray_tracer);
      setup.settings.projection = projection;
      int hits = 0;
      for (int i = 0; i < 15; ++i) {
        const Vec2i pixel(any(random), any(random));
        const EnlargedView one = enlarge(setup.view, setup.settings, Vec2d(pixel) + 0.5 - 1.0 / 2048, 1.0 / 1024, 1);
        const PixelStory own = setup.story(pixel);
        const PixelStory other = inspect(setup.scene, one.view, one.settings, {0, 0}, setup.prepared, setup.progress);
        const auto own_hits = events_of<HitEvent>(own.events), other_hits = events_of<HitEvent>(other.events);
        ASSERT_EQ(own_hits.empty(), other_hits.empty()) << name << " seed " << seed;
        if (own_hits.empty()) continue;
        ++hits;
        const auto *a = own_hits.front(), *b = other_hits.front();
        EXPECT_EQ(a->id, b->id) << name << " seed " << seed;
        EXPECT_NEAR(length(a->point - b->point), 0, 1e-9 * (1 + a->t)) << name << " seed " << seed;
      }
      EXPECT_GT(hits, 0) << name << " seed " << seed;
    }
}

// Both renderers draw the same inside of a pixel, where a triangle fills it: the rasterizer's enlarged view is not
// merely a crop.
TEST(Microscope, EnlargedPixelLooksTheSameToBothRenderers) {
  Bench traced("cgfs/crates", Renderer::ray_tracer), drawn("cgfs/crates", Renderer::rasterizer);
  const Vec2i pixel = traced.scene.start_pixel / 3;  // of 600 x 600
  const auto ids = [&](Bench& setup) {
    const EnlargedView wide = enlarge(setup.view, setup.settings, Vec2d(pixel) - 20.0, 40, 80);
    return render(setup.scene, wide.view, wide.settings, request_for(Channel::ids), setup.prepared, setup.progress).ids;
  };
  const Image<PixelId> a = ids(traced), b = ids(drawn);
  int different = 0, seen = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    different += a.pixels()[i] == b.pixels()[i] ? 0 : 1;
    seen += a.pixels()[i].object >= 0 ? 1 : 0;
  }
  EXPECT_GT(seen, 1000);
  EXPECT_LT(different, 80);  // only along edges
}

// At the pixel's own sample the microscope says what the story of the pixel says, to the last bit.
TEST(Microscope, ReadsTheKernelsOwnNumbersAtTheSample) {
  const unsigned seed = 11;
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> any(0, 199);
  int fragments = 0;
  for (const char* name : {"cgfs/crates", "cgfs/shading", "cgfs/cubes"}) {
    Bench setup(name, Renderer::rasterizer);
    for (int i = 0; i < 60; ++i) {
      const Vec2i pixel(any(random), any(random));
      const PixelStory story = setup.story(pixel);
      const Microscope scope(setup.scene, setup.view, setup.settings, pixel, setup.prepared, setup.progress);
      const MicroReading reading = scope.read({0.5, 0.5}, setup.prepared, setup.progress);
      for (const auto* reported : events_of<FragmentEvent>(story.events)) {
        const auto same = [&](const MicroTriangle& triangle) {
          return triangle.id == reported->id && triangle.edges == reported->edges &&
                 triangle.weights == reported->weights && triangle.weights_2d == reported->weights_2d &&
                 triangle.z == reported->z && triangle.covered;
        };
        EXPECT_TRUE(std::any_of(reading.triangles.begin(), reading.triangles.end(), same))
            << name << " " << pixel.x << "," << pixel.y << " seed " << seed;
        ++fragments;
      }
      ASSERT_EQ(scope.samples().size(), 1u);
      EXPECT_NE(scope.samples()[0].lit, events_of<WriteEvent>(story.events).empty()) << name << " seed " << seed;
    }
  }
  EXPECT_GT(fragments, 20) << "seed " << seed;
}

// Closed forms: edge values are twice the areas that point and edge span, weights are their shares, and in perspective
// 1/z, not z, is linear on the screen (CGFS ch. 12).
TEST(Microscope, MovedPointAgreesWithClosedForms) {
  Bench setup("cgfs/crates", Renderer::rasterizer);
  const unsigned seed = 3;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> anywhere(-0.25, 1.25);
  std::uniform_int_distribution<int> any(0, 199);
  int triangles = 0;
  for (int i = 0; i < 60; ++i) {
    const Vec2i pixel(any(random), any(random));
    const Microscope scope(setup.scene, setup.view, setup.settings, pixel, setup.prepared, setup.progress);
    const MicroReading reading = scope.read({anywhere(random), anywhere(random)}, setup.prepared, setup.progress);
    for (const MicroTriangle& t : reading.triangles) {
      ++triangles;
      const auto doubled = [](const Vec2d& a, const Vec2d& b, const Vec2d& c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
      };
      const double area = doubled(t.corners[0], t.corners[1], t.corners[2]);
      double sum = 0, inside = 1;
      for (std::size_t k = 0; k < 3; ++k) {
        const double edge = doubled(t.corners[(k + 1) % 3], t.corners[(k + 2) % 3], reading.point);
        EXPECT_NEAR(t.edges[k], area > 0 ? edge : -edge, 1e-6 * std::abs(area)) << "seed " << seed;
        EXPECT_NEAR(t.weights_2d[k], edge / area, 1e-6) << "seed " << seed;
        sum += t.weights[k];
        if (t.edges[k] < 0) inside = 0;
      }
      EXPECT_NEAR(sum, 1, 1e-9) << "seed " << seed;
      if (!t.covered) continue;
      EXPECT_EQ(inside, 1);
      EXPECT_GE(t.z_2d, t.z - 1e-9) << "the mean of z lies behind the surface";  // 1/z is convex
    }
  }
  EXPECT_GT(triangles, 30);
}

// The fill rule gives a point on the edge that two triangles share to exactly one of them; without a rule both or none
// have it.
TEST(Microscope, OneTriangleOwnsEachPointOfASharedEdge) {
  Bench setup("cgfs/crates", Renderer::rasterizer);
  setup.settings.subpixel_bits = 2;
  for (const FillRule rule : {FillRule::top_left, FillRule::inclusive, FillRule::exclusive}) {
    setup.settings.fill_rule = rule;
    int ties = 0;
    for (int y = 60; y < 140; y += 1) {
      const Vec2i pixel(110, y);
      const Microscope scope(setup.scene, setup.view, setup.settings, pixel, setup.prepared, setup.progress);
      const MicroReading at = scope.read({0.5, 0.5}, setup.prepared, setup.progress);
      for (std::size_t i = 0; i < at.triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
          const Vec2d middle = (at.triangles[i].corners[(k + 1) % 3] + at.triangles[i].corners[(k + 2) % 3]) / 2.0;
          if (middle.x < -0.25 || middle.y < -0.25 || middle.x > 1.25 || middle.y > 1.25) continue;
          const MicroReading tie = scope.read(middle, setup.prepared, setup.progress);
          if (!tie.triangles[i].ties[k]) continue;  // the middle does not lie on the grid
          int touching = 0, covering = 0;
          for (const MicroTriangle& t : tie.triangles) {
            if (!t.ties[0] && !t.ties[1] && !t.ties[2]) continue;
            const bool within = t.edges[0] >= 0 && t.edges[1] >= 0 && t.edges[2] >= 0;
            touching += within ? 1 : 0;
            covering += t.covered ? 1 : 0;
          }
          if (touching != 2) continue;  // an outline, or more triangles at a corner
          ++ties;
          EXPECT_EQ(covering, rule == FillRule::top_left ? 1 : rule == FillRule::inclusive ? 2 : 0);
        }
    }
    EXPECT_GT(ties, 0);
  }
}

// Texel weights add up to one, and the colour is their mean.
TEST(Microscope, TapsMakeTheTexturesColour) {
  Bench setup("cgfs/crates", Renderer::rasterizer);
  int read = 0;
  for (const TextureFilter filter :
       {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::mipmap, TextureFilter::trilinear}) {
    setup.settings.texture_filter = filter;
    for (int x = 20; x < 200; x += 23) {
      const Microscope scope(setup.scene, setup.view, setup.settings, {x, 110}, setup.prepared, setup.progress);
      const MicroReading reading = scope.read({0.25, 0.75}, setup.prepared, setup.progress);
      if (!reading.texture) continue;
      ++read;
      double sum = 0;
      for (const MicroTexels& level : reading.texture->levels) {
        EXPECT_EQ(level.footprint.size(), 4u);
        for (const MicroTexels::Tap& tap : level.taps) {
          sum += tap.weight;
          EXPECT_LE(std::abs(tap.x + 0.5 - level.place.x), filter == TextureFilter::nearest ? 0.5 : 1.0);
        }
      }
      EXPECT_NEAR(sum, 1, 1e-6);
    }
  }
  EXPECT_GT(read, 8);
}

// Supersampling: as many samples as rays, each lit where its own ray hit.
TEST(Microscope, ShowsEverySampleOfATracedPixel) {
  Bench setup("cgfs/reflections", Renderer::ray_tracer);
  setup.settings.samples_per_pixel = 25;
  int lit = 0, unlit = 0;
  for (int y = 60; y < 160; y += 4) {
    const Microscope scope(setup.scene, setup.view, setup.settings, {92, y}, setup.prepared, setup.progress);
    ASSERT_EQ(scope.samples().size(), 25u);
    for (const MicroSample& sample : scope.samples()) {
      const MicroReading reading = scope.read(sample.position, setup.prepared, setup.progress);
      EXPECT_EQ(sample.lit, reading.seen != "the background");
      EXPECT_EQ(sample.seen, reading.seen);
      (sample.lit ? lit : unlit) += 1;
    }
  }
  EXPECT_GT(lit, 10);
  EXPECT_GT(unlit, 10);
}

// What is shown at once has the numbers of what follows; only its picture may be coarser.
TEST(Microscope, FirstAnswerDiffersInItsPictureAlone) {
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer})
    for (const char* name : {"cgfs/reflections", "cgfs/crates", "lab/far-origin"}) {
      Bench setup(name, renderer);
      const Vec2i pixel(100, 110);
      const auto make = [&](MicroDetail detail) {
        return std::make_unique<Microscope>(setup.scene, setup.view, setup.settings, pixel, setup.prepared,
                                            setup.progress, detail);
      };
      const auto first = make(MicroDetail::first), whole = make(MicroDetail::whole);
      EXPECT_EQ(whole->detail(), MicroDetail::whole);
      EXPECT_LT(first->enlarged().width(), first->detail() == MicroDetail::first ? whole->enlarged().width() : 10000);
      ASSERT_EQ(first->samples().size(), whole->samples().size()) << name;
      for (std::size_t i = 0; i < whole->samples().size(); ++i)
        EXPECT_EQ(first->samples()[i].seen, whole->samples()[i].seen) << name;
      const Vec2d point(0.4, 0.6);
      const MicroReading a = first->read(point, setup.prepared, setup.progress);
      const MicroReading b = whole->read(point, setup.prepared, setup.progress);
      EXPECT_EQ(a.seen, b.seen) << name;
      ASSERT_EQ(a.triangles.size(), b.triangles.size()) << name;
      for (std::size_t i = 0; i < b.triangles.size(); ++i) EXPECT_EQ(a.triangles[i].edges, b.triangles[i].edges);
    }
}

TEST(Microscope, DrawsEverythingInsideItsRectangle) {
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
    Bench setup("cgfs/crates", renderer);
    setup.settings.multisampling = 4;
    const Microscope scope(setup.scene, setup.view, setup.settings, {110, 100}, setup.prepared, setup.progress);
    const MicroReading reading = scope.read({0.5, 0.5}, setup.prepared, setup.progress);
    const MicroDrawing drawing = pixel_drawing(scope, reading, -1);
    EXPECT_GT(drawing.items.size(), 5u);
    int samples = 0;
    for (const MicroItem& item : drawing.items) {
      samples += item.kind == MicroKind::sample_lit || item.kind == MicroKind::sample_unlit ? 1 : 0;
      for (const Vec2d& p : item.points) {
        EXPECT_GE(p.x, drawing.low.x - 1e-9);
        EXPECT_LE(p.y, drawing.high.y + 1e-9);
      }
    }
    EXPECT_EQ(samples, renderer == Renderer::rasterizer ? 4 : 1);
  }
}

// Filled with what parts from the surface, a covered sample does not look like a ring.
TEST(Microscope, SamplesPartFromTheSurfaceThatTheyLieOn) {
  for (const double exposure : {0.02, 50.0}) {
    Bench setup("cgfs/reflections", Renderer::ray_tracer);
    setup.settings.exposure = exposure;
    const Microscope scope(setup.scene, setup.view, setup.settings, {20, 190}, setup.prepared, setup.progress);
    const MicroReading reading = scope.read({0.5, 0.5}, setup.prepared, setup.progress);
    int samples = 0;
    for (const MicroItem& item : pixel_drawing(scope, reading, -1).items) {
      if (item.kind != MicroKind::sample_lit && item.kind != MicroKind::sample_unlit) continue;
      ++samples;
      EXPECT_EQ(item.on_dark, exposure < 1);
    }
    EXPECT_GT(samples, 0);
    const std::string svg = micro_svg(scope, reading), circle = svg.substr(svg.find("<circle"), 200);
    const std::string first_circle = circle.substr(0, circle.find("/>"));
    EXPECT_NE(first_circle.find(exposure < 1 ? "fill=\"#ffffff\"" : "fill=\"#181818\""), std::string::npos)
        << first_circle;
  }
}

// Clipping against sampling: a point of the segment or triangle survives if and only if it lies in the window.
/// Every value stands under a heading of its own, and a row is written in one notation.
TEST(Microscope, TablesHaveAHeadingForEachValue) {
  MicroTriangle triangle;
  triangle.edges = {13480.6, 6508.25, 0.5};
  triangle.uv = triangle.uv_2d = Vec2d(0.25, 0.5);
  const auto tables = triangle_tables(triangle);
  ASSERT_EQ(tables.size(), 2u);
  for (const MicroTable& table : tables)
    for (const MicroRow& row : table.rows) {
      EXPECT_EQ(row.values.size(), table.columns.size()) << row.name;
      EXPECT_EQ(row.exact.size(), table.columns.size()) << row.name;
    }
  EXPECT_EQ(tables[0].rows.front().values, (std::vector<std::string>{"13481", "6508", "0.5"}));
  EXPECT_EQ(tables[1].columns, (std::vector<std::string>{"by screen", "by space"}));
}

TEST(WindowClip, KeepsWhatIsInside) {
  const unsigned seed = 23;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-3, 3);
  const ClipWindow window{{-1, -0.5}, {1, 0.75}};
  const auto inside = [&](const Vec2d& p) {
    return p.x >= window.low.x && p.x <= window.high.x && p.y >= window.low.y && p.y <= window.high.y;
  };
  for (int i = 0; i < 2000; ++i) {
    const Vec2d a(any(random), any(random)), b(any(random), any(random)), c(any(random), any(random));
    const auto part = clip_segment(a, b, window);
    constexpr int steps = 400;
    int within = 0;
    for (int k = 0; k < steps; ++k) within += inside(a + (b - a) * ((k + 0.5) / steps)) ? 1 : 0;
    const double share = part ? length((*part)[1] - (*part)[0]) / length(b - a) : 0;
    EXPECT_NEAR(share, static_cast<double>(within) / steps, 2.5 / steps) << "seed " << seed;
    for (const Vec2d& p : clip_polygon({a, b, c}, window)) {
      EXPECT_GE(p.x, window.low.x - 1e-12);
      EXPECT_LE(p.y, window.high.y + 1e-12);
    }
  }
}

}  // namespace
}  // namespace ps::microscope_test
