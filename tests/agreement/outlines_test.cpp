// Outlines over filled triangles and the diffuse term switched off: the renderers against the listings of CGFS ch. 12
// and 13, which draw them by code of their own.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "options/option.h"
#include "options/scene_settings.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "scene/scene_text.h"
#include "support/render_once.h"
#include "support/settings_with.h"

namespace ps::outlines_test {
namespace {

Frame picture(const Scene& scene, int side, const std::vector<std::string>& assignments) {
  Settings settings = settings_with(settings_for(scene), assignments);
  return render(scene, {scene.camera, side, side}, settings, {});
}

Vec3d at(const Frame& frame, int x, int y) {
  return frame.colour_double.empty() ? Vec3d(frame.colour.at(x, y)) : frame.colour_double.at(x, y);
}

int differing(const Frame& a, const Frame& b, double tolerance) {
  int count = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const Vec3d d = at(a, x, y) - at(b, x, y);
      count += std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) > tolerance;
    }
  return count;
}

/// The conventions of the book's programs.
const std::vector<std::string> book{"renderer=rasterizer", "sample-position=corner", "precision=double",
                                    "fill-rule=inclusive", "subpixel-bits=0",        "line-algorithm=interpolate",
                                    "lighting=off"};

std::vector<std::string> with(std::vector<std::string> assignments, const std::vector<std::string>& more) {
  assignments.insert(assignments.end(), more.begin(), more.end());
  return assignments;
}

/// How many of the pixels in which `a` differs from `plain_a` have no such pixel of the other pair at most one away.
struct Strays {
  int lines = 0, strays = 0;
};
Strays strays(const Frame& a, const Frame& plain_a, const Frame& b, const Frame& plain_b) {
  const auto on_line = [](const Frame& with_lines, const Frame& plain, int x, int y) {
    const Vec3d d = at(with_lines, x, y) - at(plain, x, y);
    return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) > 0.01;
  };
  Strays found;
  for (int y = 1; y + 1 < a.height(); ++y)
    for (int x = 1; x + 1 < a.width(); ++x) {
      if (!on_line(a, plain_a, x, y)) continue;
      ++found.lines;
      bool near = false;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) near = near || on_line(b, plain_b, x + dx, y + dy);
      found.strays += near ? 0 : 1;
    }
  return found;
}

// The listing drops the fractions of vertices, so that its lines may lie one pixel beside ours.
TEST(Outlines, AreThoseOfTheListing) {
  const Scene scene = load_scene("cgfs/cubes");
  for (const char* order : {"visibility=depth-buffer", "visibility=draw-order"}) {
    const std::vector<std::string> listed{"renderer=textbook", "listing=cgfs-12-hidden-surfaces", order};
    const Frame listing = picture(scene, 600, with(listed, {"draw=outlined"})), plain = picture(scene, 600, listed);
    const Frame ours = picture(scene, 600, with(book, {"draw=outlined", order}));
    const Frame filled = picture(scene, 600, with(book, {order}));
    const Strays of_listing = strays(listing, plain, ours, filled), of_ours = strays(ours, filled, listing, plain);
    std::cout << order << ": " << of_listing.strays << " of " << of_listing.lines << " and " << of_ours.strays << " of "
              << of_ours.lines << " pixels of lines are alone\n";
    EXPECT_GT(of_listing.lines, 3000);
    EXPECT_LT(of_listing.strays, of_listing.lines / 50);
    EXPECT_LT(of_ours.strays, of_ours.lines / 50);
  }
}

// One triangle's outline is its wireframe in 3/4 of its colour, laid over its filled picture.
TEST(Outlines, OfATriangleLieOverIt) {
  const Scene scene = parse_scene(
      "viewport_size = 1 x 1\nprojection_plane_d = 1\nbackground = black\n"
      "model { name = one\n  vertices { 0 = (-0.4, -0.3, 1)  1 = (0.1, 0.4, 1)  2 = (0.3, -0.2, 1) }\n"
      "  triangles { 0 = { vertices = [0, 1, 2] color = linear (0.8, 0.4, 0.2) } }\n}\ninstance { model = one }\n",
      "one.scene", ".");
  const std::vector<std::string> plain{"renderer=rasterizer", "lighting=off"};
  for (const char* precision : {"precision=float", "precision=double"})
    for (const char* threads : {"threads=1", "threads=7"}) {
      const auto with_draw = [&](const char* draw) {
        return picture(scene, 200, with(plain, {precision, threads, draw}));
      };
      const Frame filled = with_draw("draw=filled"), lines = with_draw("draw=wireframe");
      const Frame both = with_draw("draw=outlined");
      for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x) {
          const bool on_line = at(lines, x, y) != Vec3d(0);
          const Vec3d expected = on_line ? at(lines, x, y) * 0.75 : at(filled, x, y);
          for (int c = 0; c < 3; ++c) ASSERT_NEAR(at(both, x, y)[c], expected[c], 1e-7) << x << ", " << y;
        }
    }
}

// What covers an edge later is drawn over it: of two walls the farther one's edges end at the nearer one, if that comes
// later, and lie over it if it comes first.
TEST(Outlines, AskForNoDepth) {
  const auto walls = [](double first_z, double second_z) {
    const auto wall = [](const char* name, double z, const char* colour) {
      const std::string depth = scene_number(z), half = scene_number(0.25 * z), whole = scene_number(0.375 * z);
      const std::string name_of = name;
      return "model { name = " + name_of + "\n  vertices { 0 = (-" + half + ", -" + half + ", " + depth + ")  1 = (-" +
             half + ", " + half + ", " + depth + ")  2 = (" + whole + ", " + half + ", " + depth +
             ") }\n  triangles { 0 = { vertices = [0, 1, 2] color = " + colour +
             " } }\n}\ninstance { model = " + name_of + " }\n";
    };
    return parse_scene("viewport_size = 1 x 1\nprojection_plane_d = 1\nbackground = black\n" +
                           wall("a", first_z, "red") + wall("b", second_z, "blue"),
                       "walls.scene", ".");
  };
  const auto red_pixels = [&](const Scene& scene) {
    const Frame frame = picture(scene, 100, {"renderer=rasterizer", "lighting=off", "draw=outlined"});
    int red = 0;
    for (int y = 0; y < 100; ++y)
      for (int x = 0; x < 100; ++x) red += at(frame, x, y).x > 0;
    return red;
  };
  EXPECT_EQ(red_pixels(walls(4, 2)), 0) << "the nearer one comes later and has the same outline";
  EXPECT_GT(red_pixels(walls(2, 4)), 500);
  // The later one's edges lie over the nearer one's.
  const Frame frame = picture(walls(2, 4), 100, {"renderer=rasterizer", "lighting=off", "draw=outlined"});
  int blue = 0;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 100; ++x) blue += at(frame, x, y).z > 0;
  EXPECT_GT(blue, 100);
}

// The story of a pixel on an edge: the fragment, then the line over it.
TEST(Outlines, AreInTheStory) {
  const Scene scene = load_scene("cgfs/cubes");
  Settings settings = settings_with(settings_for(scene), with(book, {"draw=outlined"}));
  const View view{scene.camera, 150, 150};
  const Frame frame = render(scene, view, settings, {});
  std::size_t lines = 0;
  for (int y = 2; y < 150; y += 14)
    for (int x = 2; x < 150; x += 4) {
      const PixelStory story = inspect(scene, view, settings, {x, y});
      EXPECT_EQ(story.linear, frame.colour_double.at(x, y)) << x << ", " << y;
      lines += events_of<LineEvent>(story.events).size();
    }
  EXPECT_GT(lines, 10u);
}

TEST(Diffuse, SpecularAloneIsThatOfTheListing) {
  const Scene scene = load_scene("cgfs/shading");
  const std::vector<std::string> own{"renderer=rasterizer", "sample-position=corner", "precision=double",
                                     "fill-rule=inclusive", "subpixel-bits=0",        "shadows=none",
                                     "diffuse=off",         "interpolation=affine"};
  const Frame listing = picture(scene, 300, {"renderer=textbook", "listing=cgfs-13-shading", "diffuse=off"});
  const Frame ours = picture(scene, 300, own);
  const Frame both_terms = picture(scene, 300, with(own, {"diffuse=on"}));
  const int off = differing(ours, listing, 0.02), changed = differing(ours, both_terms, 0.02);
  std::cout << off << " of 90000 pixels differ, the diffuse term changes " << changed << "\n";
  EXPECT_LT(off, 1800);  // borders: the listing drops the fractions of vertices
  EXPECT_GT(changed, 30000);
}

}  // namespace
}  // namespace ps::outlines_test
