// Snell's law, total internal reflection, Fresnel, and the magnifying glass against the thin-lens equation (CGFS ch.
// 5).
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <iostream>
#include <numbers>

#include "raytrace/clear/tracer.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "shade/fresnel.h"
#include "support/render_once.h"

namespace ps::refraction_test {
namespace {
using std::numbers::pi;

Vec3d at_angle(double degrees) { return {std::sin(degrees * pi / 180), -std::cos(degrees * pi / 180), 0}; }

TEST(Refraction, SnellsLawAtEveryAngle) {
  const Vec3d normal{0, 1, 0};
  for (double degrees = 0; degrees < 90; degrees += 7.5) {
    const auto bent = refract(at_angle(degrees) * 3.0, normal, 1.0, 1.5);
    ASSERT_TRUE(bent);
    EXPECT_NEAR(glm::length(bent->direction), 3, 1e-12);
    EXPECT_NEAR(bent->direction.x / 3 * 1.5, std::sin(degrees * pi / 180), 1e-12);
    EXPECT_LT(bent->direction.y, 0);
    const auto from_below = refract(at_angle(degrees), -normal, 1.0, 1.5);
    EXPECT_NEAR(from_below->direction.x, bent->direction.x / 3, 1e-12) << "the normal's side must not matter";
  }
}

TEST(Refraction, TotalReflectionBeginsAtTheCriticalAngle) {
  const double critical = std::asin(1 / 1.5) * 180 / pi;
  EXPECT_TRUE(refract(at_angle(critical - 1e-3), {0, 1, 0}, 1.5, 1.0));
  EXPECT_FALSE(refract(at_angle(critical + 1e-3), {0, 1, 0}, 1.5, 1.0));
  EXPECT_TRUE(refract(at_angle(89.9), {0, 1, 0}, 1.0, 1.5));
}

TEST(Refraction, FresnelAtNormalAndBrewsterAngleAndGrazing) {
  EXPECT_NEAR(fresnel_share(1.0, 1.0, 1.0, 1.5), 0.04, 1e-12);
  const double brewster = std::atan(1.5);
  const double inner = std::asin(std::sin(brewster) / 1.5);
  const double across = std::pow(std::sin(brewster - inner) / std::sin(brewster + inner), 2);
  EXPECT_NEAR(fresnel_share(std::cos(brewster), std::cos(inner), 1.0, 1.5), across / 2, 1e-12);
  EXPECT_NEAR(fresnel_share(1e-9, std::cos(std::asin(1 / 1.5)), 1.0, 1.5), 1, 1e-6);
}

PixelStory story_at(const Scene& scene, const Settings& settings, int width, int height, Vec2i pixel) {
  return inspect(scene, View{scene.camera, width, height}, settings, pixel);
}

/// The sum of the lines of one level, and that each line is the sum of those below it.
void expect_ledger_adds_up(const PixelStory& story) {
  Vec3d sum(0);
  for (std::size_t i = 0; i < story.ledger.size(); ++i) {
    const LedgerLine& line = story.ledger[i];
    if (line.level == 0) sum += line.value;
    Vec3d below(0);
    bool any = false;
    for (std::size_t k = i + 1; k < story.ledger.size() && story.ledger[k].level > line.level; ++k)
      if (story.ledger[k].level == line.level + 1) below += story.ledger[k].value, any = true;
    if (any) {
      EXPECT_LT(glm::length(below - line.value), 1e-5) << line.term;
    }
  }
  EXPECT_LT(glm::length(sum - story.linear), 1e-5);
}

TEST(Refraction, StoriesOfGlassAddUp) {
  const Scene scene = load_scene("cgfs/magnifying-glass");
  int refractions = 0, totals = 0;
  for (const TransparencyShare share : {TransparencyShare::fixed, TransparencyShare::fresnel}) {
    Settings settings;
    settings.reflection_depth = 6;
    settings.transparency = share;
    for (int y = 20; y < 100; y += 13)
      for (int x = 20; x < 100; x += 7) {
        const PixelStory story = story_at(scene, settings, 120, 120, {x, y});
        expect_ledger_adds_up(story);
        for (const auto* e : events_of<RefractionEvent>(story.events)) {
          ++refractions;
          totals += e->total ? 1 : 0;
          EXPECT_NEAR(e->own_share + e->mirrored_share + e->refracted_share, 1, 1e-6);
        }
      }
  }
  EXPECT_GT(refractions, 100);
  std::cout << refractions << " boundaries, " << totals << " totally reflecting\n";
}

/// A thin glass lens at the origin with a page at distance s behind it, seen by an eye on the axis.
Scene lens_scene(double radius, double page, double eye) {
  const double aperture = 0.25;
  const double offset = std::sqrt(radius * radius - aperture * aperture);
  Scene scene =
      parse_scene("intersection { sphere { center = (0,0,0) radius = 1 transparency = 1 refraction_index = 1.5 }\n"
                  "sphere { center = (0,0,0) radius = 1 transparency = 1 refraction_index = 1.5 } }\n"
                  "rectangle { corner = (-50,-50,9) side_a = (100,0,0) side_b = (0,100,0) }",
                  "lens", {});
  scene.geometry.edit([&](Geometry& geometry) {
    auto parts = csg_parts(std::get<Csg>(geometry.objects[0].shape).root);
    parts[0]->form = Ball{{0, 0, -offset}, radius};
    parts[1]->form = Ball{{0, 0, offset}, radius};
    std::get<Rectangle>(std::get<Solid>(geometry.objects[1].shape).form).corner = {-50, -50, page};
  });
  scene.camera.position = {0, 0, -eye};
  return scene;
}

/// Height on the page that the eye sees in the direction of `slope`.
double seen_height(const Scene& scene, double slope) {
  Prepared prepared;
  Settings settings;
  settings.precision = Precision::float64;
  settings.near = 0;
  Scene turned = scene;
  turned.camera.forward = {0, slope, 1};
  const PixelStory story = story_at(turned, settings, 1, 1, {0, 0});
  for (auto event = story.events.rbegin(); event != story.events.rend(); ++event)
    if (const auto* hit = std::get_if<HitEvent>(&event->data)) {
      EXPECT_EQ(hit->id.object, 1);
      return hit->point.y;
    }
  ADD_FAILURE() << "nothing seen";
  return 0;
}

// 1/s + 1/s' = 1/f with f = R for index 1.5 (lens-maker's equation, both sides alike); magnification -s'/s.
TEST(Refraction, MagnifyingGlassObeysTheThinLensEquation) {
  for (const double radius : {4.0, 8.0}) {
    const double f = radius / (2 * (1.5 - 1));
    for (const double share : {0.3, 0.5, 0.7}) {
      const double s = share * f;
      const double image = 1 / (1 / f - 1 / s);  // negative: in front of the eye, upright, enlarged
      const double magnification = -image / s;
      const double slope = 0.002;
      const double near_eye = 3, far_eye = 7;
      const double near_height = seen_height(lens_scene(radius, s, near_eye), slope);
      const double far_height = seen_height(lens_scene(radius, s, far_eye), slope);
      // The eye sees the image point h' = m h at distance D behind the lens: slope * (eye + D) = m h.
      const double m = slope * (far_eye - near_eye) / (far_height - near_height);
      const double distance = m * near_height / slope - near_eye;
      EXPECT_NEAR(m, magnification, 0.02 * magnification) << "R " << radius << ", s " << s;
      EXPECT_NEAR(distance, -image, 0.02 * -image) << "R " << radius << ", s " << s;
      std::cout << "f " << f << ", s " << s << ": image " << distance << " (" << -image << "), magnification " << m
                << " (" << magnification << ")\n";
    }
  }
}

TEST(Refraction, OffMeansStraightThrough) {
  Scene scene = lens_scene(4, 2, 3);
  scene.camera.forward = {0, 0.01, 1};
  Settings settings;
  settings.precision = Precision::float64;
  settings.near = 0;
  settings.refraction = false;
  const PixelStory story = story_at(scene, settings, 1, 1, {0, 0});
  const auto hits = events_of<HitEvent>(story.events);
  ASSERT_FALSE(hits.empty());
  EXPECT_NEAR(hits.back()->point.y, 0.05, 1e-12);
}

}  // namespace
}  // namespace ps::refraction_test
