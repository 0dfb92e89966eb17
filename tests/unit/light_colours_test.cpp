// A light's colours for the terms of the illumination equation (OCT), against the equation written out here.
#include <gtest/gtest.h>

#include <cmath>

#include "options/option.h"
#include "render/story/story_tree.h"
#include "scene/edit.h"
#include "scene/scene_file.h"
#include "scene/scene_writer.h"
#include "support/render_once.h"

namespace ps::light_colours_test {
namespace {

constexpr const char* lamp =
    "light { type = point  intensity = 0.8  position = (1, 2, -1)  color = linear (0.9, 0.2, 0.1)\n"
    "        specular_color = linear (0.1, 0.8, 0.3)  ambient_color = linear (0.05, 0.1, 0.2)\n"
    "        attenuation = (1, 0.5, 0.25) }\n";
constexpr const char* sun =
    "light { type = directional  intensity = 0.5  direction = (-1, 1, -2)  ambient_color = linear (0.1, 0, 0) }\n";

/// A wall behind a ball that throws a shadow on it. `tints`: highlights and ambient light have colours of their own.
Scene wall(const std::string& lights, const std::string& tints) {
  return parse_scene("viewport_size = 1 x 1\nprojection_plane_d = 1\nbackground = black\n"
                     "material { name = clay  color = linear (0.5, 0.25, 1)  specular = 8 " +
                         tints +
                         " }\n"
                         "model { name = wall  materials = [clay]\n"
                         "  vertices { 0 = (-3, -3, 4)  1 = (-3, 3, 4)  2 = (3, 3, 5)  3 = (3, -3, 5) }\n"
                         "  triangles { 0 = { vertices = [0, 1, 2] }  1 = { vertices = [0, 2, 3] } }\n}\n"
                         "instance { model = wall }\n"
                         "sphere { center = (0.6, 0.8, 2.5)  radius = 0.3  material = clay }\n" +
                         lights,
                     "wall.scene", ".");
}

/// The equation at a point, light by light; `dark` says of which lights it is in the shadow.
Vec3d by_hand(const Scene& scene, const Vec3d& point, const Vec3d& normal, const std::vector<bool>& dark) {
  const Material& material = scene.materials->at(0);
  const Vec3d n = normal / std::sqrt(dot(normal, normal));
  Vec3d sum(0);
  for (std::size_t i = 0; i < scene.lights->size(); ++i) {
    const Light& light = (*scene.lights)[i];
    const bool is_point = light.kind == LightKind::point;
    const Vec3d l = is_point ? light.position - point : light.direction;
    const double distance = std::sqrt(dot(l, l));
    const Vec3d& a = light.attenuation;
    const double brightness = light.intensity / (is_point ? a.x + a.y * distance + a.z * distance * distance : 1);
    const Vec3d specular = light.specular_colour ? *light.specular_colour : light.colour;
    sum += material.ambient_colour.value_or(material.colour) * light.ambient_colour * brightness;
    if (dark[i]) continue;
    const double cosine = dot(n, l) / distance;
    if (cosine > 0) sum += material.colour * light.colour * (brightness * cosine);
    const Vec3d r = n * (2 * dot(n, l)) - l;
    const double shine = dot(r, -point) / (distance * std::sqrt(dot(point, point)));
    if (shine > 0)
      sum += material.specular_colour.value_or(material.colour) * specular *
             (brightness * std::pow(shine, *material.specular));
  }
  return sum;
}

/// The largest difference between a picture and the equation at the points and in the shadows that stories report.
double largest_error(const Scene& scene, const Settings& settings, int& shadows) {
  constexpr int side = 24;
  const View view{scene.camera, side, side};
  const Frame frame = render(scene, view, settings, {});
  Settings rays = settings;
  rays.renderer = Renderer::ray_tracer;
  rays.shadows = settings.renderer == Renderer::ray_tracer ? settings.shadows : Shadows::none;
  double largest = 0;
  for (int y = 0; y < side; y += 3)
    for (int x = 0; x < side; x += 3) {
      const PixelStory story = inspect(scene, view, rays, {x, y});
      std::vector<bool> dark;
      for (const auto* light : events_of<LightEvent>(story.events)) dark.push_back(light->visible == 0);
      const auto hits = events_of<HitEvent>(story.events);
      if (hits.empty() || hits.back()->id.object != 0) continue;
      const HitEvent* hit = hits.back();
      shadows += static_cast<int>(std::count(dark.begin(), dark.end(), true));
      const Vec3d expected = by_hand(scene, hit->point, hit->shading_normal, dark);
      const Vec3d actual =
          settings.precision == Precision::float64 ? frame.colour_double.at(x, y) : Vec3d(frame.colour.at(x, y));
      for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(expected[c] - actual[c]));
    }
  return largest;
}

TEST(LightColours, EachTermHasItsOwn) {
  for (const char* tints : {"", "specular_color = linear (1, 1, 0.5)  ambient_color = linear (0.2, 0.4, 0.8)"}) {
    const Scene scene = wall(std::string(lamp) + sun, tints);
    int shadows = 0;
    Settings settings;
    EXPECT_LT(largest_error(scene, settings, shadows), 2e-6) << tints;
    EXPECT_GT(shadows, 2) << "the ambient light of a light that is blocked must be seen somewhere";
    settings.precision = Precision::float64;
    EXPECT_LT(largest_error(scene, settings, shadows), 1e-13) << tints;
    settings.renderer = Renderer::rasterizer;
    settings.shadows = Shadows::none;
    settings.subpixel_bits = 12;
    EXPECT_LT(largest_error(scene, settings, shadows), 2e-3) << tints;  // vertices are rounded to sub-pixels
  }
}

TEST(LightColours, OneColourForAllIsTheSamePicture) {
  const std::string plain =
      "light { type = point  intensity = 0.8  position = (1, 2, -1)  color = linear (0.9, 0.2, 0.1) ";
  const Scene implicit = wall(plain + "}\n", ""),
              stated = wall(plain + "specular_color = linear (0.9, 0.2, 0.1)  ambient_color = black }\n", "");
  const Settings settings;
  const Frame a = render(implicit, {implicit.camera, 40, 40}, settings, {});
  const Frame b = render(stated, {stated.camera, 40, 40}, settings, {});
  EXPECT_EQ(a.colour.pixels().size(), b.colour.pixels().size());
  EXPECT_TRUE(std::equal(a.colour.pixels().begin(), a.colour.pixels().end(), b.colour.pixels().begin()));
  EXPECT_FALSE(scene_traits(stated).term_colours);
}

// Every line of a story's sum is there, and they add up to the pixel.
TEST(LightColours, TheStoryAddsThemUp) {
  const Scene scene = wall(std::string(lamp) + sun, "");
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
    Settings settings{.renderer = renderer};
    settings.shadows = Shadows::none;
    const PixelStory story = inspect(scene, {scene.camera, 24, 24}, settings, {9, 12});
    std::string terms;
    for (const LedgerLine& line : story.ledger) terms += line.term + "\n";
    for (const char* term : {"ambient: ", "diffuse: ", "specular: "})
      EXPECT_NE(terms.find(term), std::string::npos) << terms;
    Vec3d sum(0);
    for (const LedgerLine& line : story.ledger)
      if (line.level == 0) sum += line.value;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], story.linear[c], 1e-6) << terms;
  }
}

TEST(LightColours, AreWrittenReadAndEdited) {
  Scene scene = wall(std::string(lamp) + sun, "");
  const Scene again = parse_scene(write_scene(scene, "."), "again.scene", ".");
  EXPECT_EQ(*again.lights, *scene.lights);
  set_property(scene, "light.1.specular_color", "linear (0, 0, 1)");
  set_property(scene, "light.0.radius", "0.25");
  EXPECT_EQ((*scene.lights)[1].specular_colour, (Vec3d{0, 0, 1}));
  EXPECT_EQ(get_property(scene, "light.0.radius"), "0.25");
  for (const char* wrong : {"light { type = ambient  intensity = 1  specular_color = red }",
                            "light { type = ambient  intensity = 1  ambient_color = red }",
                            "light { type = directional  intensity = 1  direction = (0, 1, 0)  radius = 1 }",
                            "light { type = point  intensity = 1  position = (0, 1, 0)  radius = -1 }"})
    EXPECT_THROW(parse_scene(wrong, "wrong.scene", "."), InputError) << wrong;
}

}  // namespace
}  // namespace ps::light_colours_test
