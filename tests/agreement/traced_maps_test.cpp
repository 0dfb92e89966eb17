// Shadow maps looked up by rays (CGPP 15.6.5): the answers that fragments get at the same points, against closed forms
// of a shadow's edge, of acne, and of a mirror's picture.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "options/scene_settings.h"
#include "raster/shadow/shadow_map.h"
#include "render/fast_path.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "support/render_once.h"

namespace ps::traced_maps_test {
namespace {

Settings by_maps(Settings settings, int size, int filter = 1) {
  settings.renderer = Renderer::ray_tracer;
  settings.shadows = Shadows::map;
  settings.shadow_map_size = size;
  settings.shadow_filter = filter;
  return settings;
}

Settings by_fragments(Settings settings) {
  settings.renderer = Renderer::rasterizer;
  settings.subpixel_bits = 12;  // a fragment lies where the ray of its pixel meets the triangle, but for snapping
  settings.tessellation = 0.05;
  settings.shading = Shading::phong;
  settings.backface_culling = false;
  return settings;
}

Frame shadow_picture(const Scene& scene, const Settings& settings, int width = 120, int height = 80) {
  return render(scene, {scene.camera, width, height}, settings, request_for(Channel::ids | Channel::shadow));
}

/// Does a small step of the point change what it is compared with, or the outcome? Then it lies at a border of texels,
/// or as deep as the texel within `depth` of its own depth.
bool is_on_the_edge(const ShadowMapEvent& event, double texels, double depth) {
  for (const double place : {event.position.x, event.position.y})
    if (std::abs(place - std::round(place)) < texels) return true;
  return std::abs(event.depth - event.bias - event.taps.front().stored) < depth * event.depth;
}

struct Compared {
  int shared = 0, shadowed = 0, differing = 0, unexplained = 0, on_chords = 0;
};

// On triangles ray and fragment stand at the same point up to rounding, so that only points on the very border between
// two texels may be answered differently. On a ball the fragment stands on a chord.
Compared compare(const Scene& scene, const Settings& rays) {
  const Frame traced = shadow_picture(scene, rays), drawn = shadow_picture(scene, by_fragments(rays));
  Compared all;
  for (int y = 0; y < traced.height(); ++y)
    for (int x = 0; x < traced.width(); ++x) {
      const PixelId a = traced.ids.at(x, y), b = drawn.ids.at(x, y);
      if (a.object < 0 || a.object != b.object) continue;
      const bool exact = std::holds_alternative<Instance>(scene.geometry->objects[std::size_t(a.object)].shape);
      if (exact && !(a == b)) continue;
      ++all.shared;
      const std::uint32_t mask = traced.shadow.at(x, y);
      all.shadowed += mask != 0 ? 1 : 0;
      if (mask == drawn.shadow.at(x, y)) continue;
      ++all.differing;
      if (!exact) {
        ++all.on_chords;
        continue;
      }
      bool edge = false;
      const PixelStory story = inspect(scene, {scene.camera, traced.width(), traced.height()}, rays, {x, y});
      for (const auto* event : events_of<ShadowMapEvent>(story.events))
        edge = edge || event->outside || is_on_the_edge(*event, 0.02, 1e-5);
      all.unexplained += edge ? 0 : 1;
    }
  return all;
}

TEST(TracedMaps, RaysAndFragmentsGetTheSameAnswer) {
  for (const char* name : {"cgfs/crates", "cgfs/shading", "lab/inside-shadow", "lab/stacked-shadows", "lab/shadow-acne",
                           "octree/attenuation", "cgpp/ground-by-hardware", "cgfs/shadows"})
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      const Scene scene = load_scene(name);
      Settings settings = by_maps(settings_for(scene), 256);
      settings.reflection_depth = 0;
      settings.precision = precision;
      const Compared found = compare(scene, settings);
      std::printf("%-24s %s: %5d points, %5d in shadow, %3d differ, %d of them on balls\n", name,
                  precision == Precision::float32 ? "float " : "double", found.shared, found.shadowed, found.differing,
                  found.on_chords);
      EXPECT_GT(found.shared, 500) << name;
      EXPECT_EQ(found.unexplained, 0) << name;
      EXPECT_LT(found.differing - found.on_chords, std::max(3, found.shared / 200)) << name;
      EXPECT_LT(found.on_chords, found.shared / 50) << name;
      EXPECT_GT(found.shadowed, 10) << name;
    }
}

// The maps are the same ones, as the channel shows them.
TEST(TracedMaps, AreTheMapsOfTheRasterizer) {
  const Scene scene = load_scene("cgfs/shadows");
  const Settings rays = by_maps(settings_for(scene), 64);
  Settings triangles = rays;
  triangles.renderer = Renderer::rasterizer;
  const View view{scene.camera, 120, 90};
  const Frame a = render(scene, view, rays, request_for(Channel::shadow_map)),
              b = render(scene, view, triangles, request_for(Channel::shadow_map));
  EXPECT_EQ(a.shadow_map, b.shadow_map);
  EXPECT_GT(*std::max_element(a.shadow_map.pixels().begin(), a.shadow_map.pixels().end()), 0);
  EXPECT_EQ(*a.counters.get(Counter::shadow_rays), 0u);
}

// Rays meet the triangles of a curved model as it was made, so their maps hold these, however finely the rasterizer
// divides it for its own.
TEST(TracedMaps, HoldTheTrianglesThatRaysMeet) {
  const Scene scene = parse_scene("model { name = pot  generator = teapot  divisions = 2  color = orange }\n"
                                  "instance { model = pot  transform { scale = 0.3  translation = (0, -0.3, 3) } }\n"
                                  "light { type = directional  intensity = 0.7  direction = (1, 2, -2) }\n",
                                  "pot.scene", ".");
  const auto map_of = [&](Renderer renderer, Patches patches) {
    Settings settings = by_maps({}, 64);
    settings.renderer = renderer;
    settings.patches = patches;
    return render(scene, {scene.camera, 60, 60}, settings, request_for(Channel::shadow_map)).shadow_map;
  };
  const auto made = map_of(Renderer::ray_tracer, Patches::as_made);
  EXPECT_EQ(map_of(Renderer::ray_tracer, Patches::projected_error), made);
  EXPECT_EQ(map_of(Renderer::rasterizer, Patches::as_made), made);
  EXPECT_NE(map_of(Renderer::rasterizer, Patches::projected_error), made);
}

const Vec3d ball{0.3, 1.2, 4};
constexpr double ball_radius = 0.7, eye_height = 7;
const Vec3d lamp{-1.5, 4, 3}, sun{0.6, 2, -0.5};

/// A ball above a floor, seen from straight above; the picture shows 8 x 8 units of the floor.
Scene ball_over(const std::string& floor, const std::string& light) {
  return parse_scene("viewport_size = 4 x 4\nprojection_plane_d = 3.5\n"
                     "camera { position = (0, 7, 4)  forward = (0, -1, 0)  up = (0, 0, 1)  right = (1, 0, 0) }\n" +
                         floor + "sphere { center = (0.3, 1.2, 4)  radius = 0.7  color = red }\n" + light,
                     "ball.scene", ".");
}

const std::string flat_floor = "rectangle { corner = (-6, 0, -2)  side_a = (0, 0, 12)  side_b = (12, 0, 0) }\n",
                  endless_floor = "plane { point = (0, 0, 0)  normal = (0, 1, 0) }\n",
                  sunlight = "light { type = directional  intensity = 1  direction = (0.6, 2, -0.5) }\n",
                  lamplight = "light { type = point  intensity = 1  position = (-1.5, 4, 3) }\n";

/// The point of the floor that a pixel of a square picture shows.
Vec3d floor_point(int x, int y, int side) {
  return {8 * ((x + 0.5) / side - 0.5), 0, 4 + 8 * (0.5 - (y + 0.5) / side)};
}

/// How far outside the ball the light passes that reaches the point, in texels; below 0 it is blocked.
double texels_from_edge(const Scene& scene, const Vec3d& point, int size) {
  if (scene.lights->front().kind == LightKind::directional) {
    const Vec3d across = cross(ball - point, sun);
    const double passes = std::sqrt(dot(across, across) / dot(sun, sun));
    const raster::ShadowMap map = raster::empty_directional_map(scene, scene.lights->front(), size);
    return (passes - ball_radius) / (2 * map.half / size);
  }
  // The angle at the lamp. Texels in the middle of a face see the largest: 2 / size.
  const Vec3d to_point = point - lamp, to_ball = ball - lamp;
  const double near = std::sqrt(dot(to_ball, to_ball)), far = std::sqrt(dot(to_point, to_point));
  const double angle = std::acos(dot(to_point, to_ball) / near / far) - std::asin(ball_radius / near);
  return angle * size / 2;
}

// A texel answers for its centre, which is up to 0.71 texels away, and the map's ball is made of chords, which lie up
// to half a texel within it.
TEST(TracedMaps, EdgesLieWithinATexelOfTheClosedForm) {
  constexpr int side = 160;
  for (const std::string& floor : {flat_floor, endless_floor})
    for (const std::string& light : {sunlight, lamplight})
      for (const int size : {64, 256})
        for (const Precision precision : {Precision::float32, Precision::float64}) {
          const Scene scene = ball_over(floor, light);
          Settings settings = by_maps({}, size);
          settings.precision = precision;
          const Frame frame = shadow_picture(scene, settings, side, side);
          int dark = 0, wrong = 0, on_the_ball = 0;
          double nearest = -1e9;  // to the edge from within, of the points that are dark
          for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
              const bool shadowed = frame.shadow.at(x, y) != 0;
              if (frame.ids.at(x, y).object != 0) {
                on_the_ball += shadowed ? 0 : 1;
                continue;
              }
              const double outside = texels_from_edge(scene, floor_point(x, y, side), size);
              dark += shadowed ? 1 : 0;
              if (shadowed) nearest = std::max(nearest, outside);
              wrong += shadowed ? outside > 0.75 : outside < -1.25;
            }
          EXPECT_EQ(wrong, 0) << floor << light << size;
          EXPECT_GT(dark, 150) << floor << light << size;
          EXPECT_GT(nearest, -1) << "the shadow reaches its edge";
          EXPECT_GT(on_the_ball, 300) << "and the lit side of the ball is lit";
        }
}

// Across half of a texel the floor is farther from the light than its middle: without a bias that half is dark. Shadow
// rays have no texels.
TEST(TracedMaps, WithoutBiasHalfTheFloorShadowsItself) {
  constexpr int side = 200, size = 48;
  const double slope = std::sqrt(0.6 * 0.6 + 0.5 * 0.5) / 2;  // of the floor as the sun sees it
  const Scene scene = ball_over(flat_floor, sunlight);
  const raster::ShadowMap map = raster::empty_directional_map(scene, scene.lights->front(), size);
  const double texel = 2 * map.half / size;
  const auto acne = [&](const Settings& settings) {
    const Frame frame = shadow_picture(scene, settings, side, side);
    int lit = 0, dark = 0;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        if (frame.ids.at(x, y).object != 0) continue;
        const Vec3d from_map = floor_point(x, y, side) - map.position;
        const bool on_map = std::max(std::abs(dot(from_map, map.frame.right)), std::abs(dot(from_map, map.frame.up))) <
                            map.half - texel;
        if (!on_map || texels_from_edge(scene, floor_point(x, y, side), size) < 2) continue;
        ++lit;
        dark += frame.shadow.at(x, y) != 0 ? 1 : 0;
      }
    EXPECT_GT(lit, 1000);
    return 100.0 * dark / lit;
  };
  Settings settings = by_maps({}, size);
  EXPECT_EQ(acne(settings), 0) << "the bias that is computed";
  settings.shadow_slope_bias = 0;
  EXPECT_NEAR(acne(settings), 50, 4);
  // The part of a square, whose depth rises along (a, b), that lies deeper than its middle by the bias.
  settings.shadow_bias = 0.71 * texel * slope;
  EXPECT_LT(acne(settings), 0.5) << "the corner of a texel is nowhere deeper";
  settings.shadow_bias = 0.2 * texel * slope;
  const double some = acne(settings);
  EXPECT_GT(some, 10);
  EXPECT_LT(some, 40);
  settings.shadow_bias = 0;
  settings.shadows = Shadows::traced;
  EXPECT_EQ(acne(settings), 0);
}

// A perfect mirror shows what an eye behind it would see, mirrored: each reflected ray looks up its own point, and not
// the one on the mirror.
TEST(TracedMaps, MirrorsShowTheShadowsOfTheirOwnPoints) {
  const std::string room =
      "viewport_size = 1 x 1\nprojection_plane_d = 1\n"
      "rectangle { corner = (-2, -1, 3)  side_a = (4, 0, 0)  side_b = (0, 3, 0)  color = white  reflective = 1 }\n"
      "rectangle { corner = (-6, -1, -9)  side_a = (0, 0, 12)  side_b = (12, 0, 0)  color = white }\n"
      "sphere { center = (-0.4, 0.3, -1)  radius = 0.6  color = green }\n"
      "triangle { vertices = [(0.5, 0, -2), (1.5, 0, -2), (1, 1.2, -3)]  color = blue }\n"
      "light { type = ambient  intensity = 0.2 }\n"
      "light { type = directional  intensity = 0.5  direction = (0.5, 2, -1) }\n"
      "light { type = point  intensity = 0.3  position = (1, 3, -4) }\n";
  const Scene scene = parse_scene(room, "room.scene", ".");
  constexpr int side = 150;
  Settings settings = by_maps({}, 64);
  settings.precision = Precision::float64;
  const Frame mirrored = shadow_picture(scene, settings, side, side);
  Camera behind = scene.camera;
  behind.position = {0, 0, 6};
  behind.forward = {0, 0, -1};
  Settings through = settings;
  through.near = 3.0001;  // behind the mirror
  const Frame direct = render(scene, {behind, side, side}, through);
  through.shadows = Shadows::none;
  const Frame bare = render(scene, {behind, side, side}, through);
  int shown = 0, wrong = 0, shadowed = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      if (mirrored.ids.at(x, y).object != 0) continue;
      const auto far = [&](const Vec3d& a, const Vec3d& b) { return std::sqrt(dot(a - b, a - b)) > 1e-6; };
      ++shown;
      wrong += far(mirrored.colour_double.at(x, y), direct.colour_double.at(x, y)) ? 1 : 0;
      shadowed += far(bare.colour_double.at(x, y), direct.colour_double.at(x, y)) ? 1 : 0;
    }
  EXPECT_GT(shown, 8000);
  EXPECT_GT(shadowed, 500) << "there are shadows in the mirror";
  EXPECT_LE(wrong, 3) << "of " << shown;
}

// Each look-up of a story is of the point that its ray hit, and the picture is what the story says.
TEST(TracedMaps, StoriesLookUpThePointOfTheirRay) {
  const Scene scene = load_scene("cgfs/reflections");
  Settings settings = by_maps(settings_for(scene), 128, 3);
  const View view{scene.camera, 120, 120};
  const Frame frame = render(scene, view, settings, request_for(Channel::shadow | Channel::ids));
  int reflected = 0, named = 0;
  for (int y = 2; y < 120; y += 9)
    for (int x = 2; x < 120; x += 9) {
      const PixelStory story = inspect(scene, view, settings, {x, y});
      ASSERT_EQ(Vec3f(story.linear), frame.colour.at(x, y));
      EXPECT_EQ(*story.counters.get(Counter::shadow_rays), 0u);
      std::size_t taps = 0;  // a point beside the map needs none
      for (const auto* event : events_of<ShadowMapEvent>(story.events)) taps += event->outside ? 0 : 9;
      EXPECT_EQ(*story.counters.get(Counter::shadow_map_taps), taps);
      std::uint32_t mask = 0;
      for (const Event& event : story.events) {
        const auto* look_up = std::get_if<ShadowMapEvent>(&event.data);
        if (!look_up) continue;
        const auto& ray = std::get<RayEvent>(story.events[std::size_t(event.parent)].data);
        const HitEvent* hit = nullptr;
        for (const Event& other : story.events)
          if (other.parent == event.parent && !hit) hit = std::get_if<HitEvent>(&other.data);
        ASSERT_NE(hit, nullptr);
        reflected += ray.kind == RayKind::reflection ? 1 : 0;
        const Light& light = (*scene.lights)[std::size_t(look_up->light)];
        if (look_up->outside) continue;
        double depth = 0;
        if (look_up->cube) {
          const Vec3d from = glm::abs(hit->point - light.position);
          depth = std::max({from.x, from.y, from.z});
        } else {
          const raster::ShadowMap map = raster::empty_directional_map(scene, light, 128);
          depth = dot(map.frame.forward, hit->point - map.position);
        }
        EXPECT_NEAR(look_up->depth, depth, 1e-3 * std::abs(depth) + 1e-3);
        EXPECT_EQ(look_up->taps.size(), 9u);
        if (ray.kind == RayKind::eye && look_up->visible <= 0.5) mask |= 1u << look_up->light;
      }
      EXPECT_EQ(frame.shadow.at(x, y), mask);
      named += story.verdict.find("lies in the shadow of light") != std::string::npos ? 1 : 0;
    }
  EXPECT_GT(reflected, 20);
  EXPECT_GT(named, 3);
}

// SIMD finds the hits on triangles, but shades none; it leaves spheres to scalar code altogether. Neither it nor
// threads change the picture.
TEST(TracedMaps, ScalarCodeAloneLooksThemUp) {
  for (const char* name : {"cgfs/shadows", "cgfs/shading"}) {
    const Scene scene = load_scene(name);
    Settings settings = by_maps(settings_for(scene), 128);
    const FastPath path = fast_path(settings, scene_traits(scene), Channel::none);
    EXPECT_NE(path.shading, SurfaceShading::lanes);
    settings.simd = Simd::off;
    const Frame scalar = shadow_picture(scene, settings);
    settings.simd = Simd::automatic;
    for (const int threads : {1, 2, 7}) {
      settings.threads = threads;
      const Frame frame = shadow_picture(scene, settings);
      EXPECT_EQ(frame.colour, scalar.colour) << name;
      EXPECT_EQ(frame.shadow, scalar.shadow) << name;
    }
  }
}

}  // namespace
}  // namespace ps::traced_maps_test
