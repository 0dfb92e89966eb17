// Gouraud and flat shading in a story: the light at each vertex of the triangle, or at its centre, with its weight, and
// what parts such a picture from one that computes the light at each pixel (CGFS ch. 13).
#include <gtest/gtest.h>

#include <cmath>

#include "inspect/parting/parting.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "render/story/light_terms.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "support/render_once.h"
#include "support/settings_with.h"

namespace ps::vertex_light_test {
namespace {

/// One triangle; a light near the middle of it whose highlight is small.
Scene one_triangle(const std::string& light = "(0, 0, 2.6)") {
  return parse_scene("light { type = ambient intensity = 0.1 }\n"
                     "light { type = point intensity = 0.9 position = " +
                         light +
                         " }\n"
                         "triangle { name = T vertices = [(-2, -1.5, 3), (0, 2, 3), (2, -1.5, 3)] color = white "
                         "specular = 50 sides = two }\n",
                     "t.scene", ".");
}

PixelStory story_of(const Scene& scene, std::initializer_list<const char*> assignments, Vec2i pixel) {
  Settings settings = settings_with(settings_for(scene, Renderer::rasterizer), assignments);
  return inspect(scene, {scene.camera, 60, 60}, settings, pixel);
}

/// Ambient light, and diffuse and specular light of the point light, by the equation in double; the eye is at 0.
double light_by_hand(const Vec3d& at, const Vec3d& normal, const Vec3d& light) {
  const Vec3d l = light - at, v = -at;
  double sum = 0.1;
  const double cosine = dot(normal, l);
  if (cosine > 0) sum += 0.9 * cosine / (length(normal) * length(l));
  const Vec3d r = normal * (2 * dot(normal, l)) - l;
  if (dot(r, v) > 0) sum += 0.9 * std::pow(dot(r, v) / (length(r) * length(v)), 50);
  return sum;
}

TEST(VertexLight, GouraudNamesTheThreeVerticesWithTheirWeightsAndLights) {
  const Scene scene = one_triangle();
  const Vec3d vertices[3] = {{-2, -1.5, 3}, {0, 2, 3}, {2, -1.5, 3}};
  for (const char* shadows : {"shadows=none", "shadows=map"})
    for (const char* interpolation : {"interpolation=perspective", "interpolation=affine"}) {
      const PixelStory story =
          story_of(scene, {"shading=gouraud", shadows, interpolation, "precision=double"}, {25, 40});
      const auto points = events_of<VertexLightEvent>(story.events);
      ASSERT_EQ(points.size(), 3u) << shadows;
      double sum = 0, weights = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(points[k]->vertex, static_cast<int>(k));
        EXPECT_EQ(points[k]->position, vertices[k]);
        EXPECT_NEAR(points[k]->light.x, light_by_hand(vertices[k], points[k]->normal, {0, 0, 2.6}), 1e-12);
        sum += points[k]->weight * points[k]->light.x;
        weights += points[k]->weight;
      }
      EXPECT_NEAR(weights, 1, 1e-12);
      EXPECT_NEAR(sum, story.linear.x, 1e-12);
      // Each vertex has both lights below it, with nothing of them elsewhere.
      int lights = 0;
      for (std::size_t i = 0; i < story.events.size(); ++i)
        if (std::holds_alternative<VertexLightEvent>(story.events[i].data)) {
          EXPECT_EQ(events_below<LightEvent>(story.events, static_cast<int>(i)).size(), 2u);
          lights += 2;
        }
      EXPECT_EQ(lights, 6);
      // The sum of the pixel has a line for each vertex, and its terms below that line.
      std::vector<const LedgerLine*> lines;
      for (const LedgerLine& line : story.ledger)
        if (line.term.find("vertex ") == 0) lines.push_back(&line);
      ASSERT_EQ(lines.size(), 3u);
      double total = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NE(lines[k]->term.find("weight"), std::string::npos) << lines[k]->term;
        EXPECT_NEAR(lines[k]->value.x, points[k]->weight * points[k]->light.x, 1e-12);
        double terms = 0;
        for (const LedgerLine* line = lines[k] + 1; line->level > lines[k]->level; ++line)
          if (line->level == lines[k]->level + 1) terms += line->value.x;
        EXPECT_NEAR(terms, lines[k]->value.x, 1e-12);
        total += lines[k]->value.x;
      }
      EXPECT_NEAR(total, story.linear.x, 1e-12);
    }
}

TEST(VertexLight, TheLineOfAVertexSaysHowMuchOfItsLightIsHighlight) {
  // The light is seen in the mirror of vertex 1 alone.
  const Scene scene = one_triangle("(0, 2, 2.4)");
  const PixelStory story = story_of(scene, {"shading=gouraud", "shadows=none"}, {30, 28});
  const auto points = events_of<VertexLightEvent>(story.events);
  ASSERT_EQ(points.size(), 3u);
  int said = 0;
  for (std::size_t i = 0; i < story.events.size(); ++i) {
    const auto* point = std::get_if<VertexLightEvent>(&story.events[i].data);
    if (!point) continue;
    double specular = 0;
    for (const int light : events_below<LightEvent>(story.events, static_cast<int>(i)))
      specular += event_as<LightEvent>(story.events, light).specular;
    EXPECT_DOUBLE_EQ(highlight_of_point(story, scene, static_cast<int>(i)).x, specular);
    for (const LedgerLine& line : story.ledger)
      if (line.event == static_cast<int>(i)) {
        EXPECT_EQ(line.term.find("of which highlight") != std::string::npos, specular > 1e-13) << line.term;
        said += specular > 1e-13 ? 1 : 0;
      }
  }
  EXPECT_GT(said, 0);
}

TEST(VertexLight, AClippedTriangleHasTheWeightsOfItsOwnVertices) {
  const Scene scene =
      parse_scene("light { type = point intensity = 1 position = (0.3, 1, 1) }\n"
                  "triangle { vertices = [(-1, -1, 4), (0, 1.5, 2), (1, -1, -3)] color = white sides = two }\n",
                  "t.scene", ".");
  int seen = 0;
  for (int x = 20; x < 40; x += 3) {
    const PixelStory story = story_of(scene, {"shading=gouraud", "shadows=none", "precision=double"}, {x, 30});
    const auto points = events_of<VertexLightEvent>(story.events);
    if (points.size() != 3) continue;
    ++seen;
    double sum = 0;
    for (const auto* point : points) sum += point->weight * point->light.x;
    EXPECT_NEAR(sum, story.linear.x, 1e-9);
  }
  EXPECT_GT(seen, 2);
}

TEST(VertexLight, FlatShadingNamesTheCentre) {
  const Scene scene = one_triangle();
  for (const char* shadows : {"shadows=none", "shadows=map"}) {
    const PixelStory story = story_of(scene, {"shading=flat", shadows, "precision=double"}, {25, 40});
    const auto points = events_of<VertexLightEvent>(story.events);
    ASSERT_EQ(points.size(), 1u);
    EXPECT_FALSE(points[0]->vertex);
    EXPECT_EQ(points[0]->weight, 1);
    const Vec3d centre{0, -1.0 / 3, 3};
    EXPECT_NEAR(length(points[0]->position - centre), 0, 1e-12);
    EXPECT_NEAR(points[0]->light.x, light_by_hand(centre, points[0]->normal, {0, 0, 2.6}), 1e-12);
    int lines = 0;
    for (const LedgerLine& line : story.ledger) lines += line.term.find("centre of the triangle") == 0 ? 1 : 0;
    EXPECT_EQ(lines, 1);
  }
  const PixelStory phong = story_of(scene, {"shading=phong"}, {25, 40});
  EXPECT_TRUE(events_of<VertexLightEvent>(phong.events).empty());
}

/// The sentence on what parts A from B, both on the rasterizer but for what is assigned.
std::string parting_sentence(const Scene& scene, std::initializer_list<const char*> a,
                             std::initializer_list<const char*> b, Vec2i pixel) {
  const auto settings_of = [&](std::initializer_list<const char*> assignments) {
    Settings settings = settings_for(scene, Renderer::rasterizer);
    settings.shadows = Shadows::none;
    for (const char* one : assignments) parse_assignment(one, settings);
    return settings;
  };
  const Settings of_a = settings_of(a), of_b = settings_of(b);
  const View view{scene.camera, 60, 60};
  const PixelStory story_a = inspect(scene, view, of_a, pixel);
  const PixelStory story_b = inspect(scene, view, of_b, pixel);
  const Parting parting = find_parting(scene, {story_a, of_a}, {story_b, of_b});
  EXPECT_EQ(parting.cause, PartingCause::shading_position) << parting.sentence;
  return parting.sentence;
}

// The light is before the centre of the triangle: its highlight is there, and no vertex has it.
TEST(VertexLight, PartingGivesTheNumbersOfBothSides) {
  const Scene scene = one_triangle();
  const std::string gouraud = parting_sentence(scene, {"shading=gouraud"}, {"shading=phong"}, {30, 30});
  for (const char* words :
       {"A mixes the light of three vertices, ", " x ", " = ", "none of which catches the highlight of light 1",
        "B evaluates the light at the pixel itself and gets ", "is the highlight of light 1",
        "shading is gouraud in A and phong in B"})
    EXPECT_NE(gouraud.find(words), std::string::npos) << words << "\n" << gouraud;
  const std::string flat = parting_sentence(scene, {"shading=phong"}, {"shading=flat"}, {30, 30});
  for (const char* words :
       {"A evaluates the light at the pixel itself", "B takes the light at the centre of the triangle"})
    EXPECT_NE(flat.find(words), std::string::npos) << words << "\n" << flat;
  const std::string rays = parting_sentence(scene, {"shading=gouraud"}, {"renderer=ray-tracer"}, {30, 30});
  EXPECT_NE(rays.find("A mixes the light of three vertices"), std::string::npos) << rays;
  // A light that vertex 1 mirrors into the eye.
  const std::string one =
      parting_sentence(one_triangle("(0, 2.4, 2.4)"), {"shading=gouraud"}, {"shading=phong"}, {30, 28});
  EXPECT_NE(one.find("one of which catches the highlight of light 1"), std::string::npos) << one;
}

}  // namespace
}  // namespace ps::vertex_light_test
