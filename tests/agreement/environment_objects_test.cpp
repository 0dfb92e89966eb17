// Environment maps without the dynamic objects (CGFS ch. 15), against traced reflections with and without them.
#include <gtest/gtest.h>

#include <array>
#include <memory>

#include "raster/maps.h"
#include "render/left_out.h"
#include "render/story/story_tree.h"
#include "scene/edit.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "scene/scene_writer.h"
#include "support/render_once.h"

namespace ps::environment_objects_test {
namespace {

constexpr int side = 240;
constexpr std::size_t mirror = 0, moving = 1, still = 2;

/// All that is mirrored is far from the mirror, so the map shows what its rays would meet.
Scene mirror_and_far_balls() {
  return parse_scene("viewport_size = 1 x 1\nprojection_plane_d = 1\nbackground = (40, 60, 90)\n"
                     "camera { position = (0, 0, -2) }\n"
                     "light { type = ambient intensity = 1 }\n"
                     "sphere { name = mirror center = (0, 0, 0) radius = 0.4 color = white reflective = 0.8 }\n"
                     "sphere { name = moving dynamic = on center = (120, 40, -60) radius = 90 color = red }\n"
                     "sphere { name = still center = (-110, 70, -80) radius = 90 color = green }\n",
                     "far.scene", ".");
}

Frame drawn(const Scene& scene, Renderer renderer, EnvironmentObjects objects = EnvironmentObjects::all) {
  Settings settings{.renderer = renderer};
  settings.shadows = Shadows::none;
  settings.reflection_depth = 1;
  settings.environment = Environment::cube_map;
  settings.environment_objects = objects;
  settings.environment_size = 512;
  settings.backface_culling = true;
  return render(scene, {scene.camera, side, side}, settings, request_for(Channel::ids));
}

/// Which pixels of the mirror show the dynamic object, by what rays find with and without it.
enum class Mirrored { no, border, yes };
Mirrored mirrored_around(const Frame& with, const Frame& without, int x, int y) {
  constexpr int reach = 2;  // the map's texels, and triangles in place of the sphere
  int differ = 0, all = 0;
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx) {
      const int column = std::clamp(x + dx, 0, side - 1), row = std::clamp(y + dy, 0, side - 1);
      if (with.ids.at(column, row).object != static_cast<int>(mirror)) return Mirrored::border;
      ++all;
      differ += with.colour.at(column, row) != without.colour.at(column, row);
    }
  return differ == 0 ? Mirrored::no : differ == all ? Mirrored::yes : Mirrored::border;
}

TEST(EnvironmentObjects, LeavesOutThePixelsThatMirrorDynamicObjectsAndNoOthers) {
  const Scene scene = mirror_and_far_balls();
  Scene rest = scene;
  rest.geometry.edit([](Geometry& g) { g.objects.erase(g.objects.begin() + moving); });
  const Frame with = drawn(scene, Renderer::ray_tracer), without = drawn(rest, Renderer::ray_tracer);
  const Frame all = drawn(scene, Renderer::rasterizer);
  const Frame fixed = drawn(scene, Renderer::rasterizer, EnvironmentObjects::fixed);
  const Frame empty = drawn(rest, Renderer::rasterizer);
  int mirrored = 0, others = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      if (all.ids.at(x, y).object == static_cast<int>(mirror)) {
        EXPECT_EQ(fixed.colour.at(x, y), empty.colour.at(x, y)) << "as if it were not there: " << x << ", " << y;
      }
      switch (mirrored_around(with, without, x, y)) {
      case Mirrored::no:
        ++others;
        EXPECT_EQ(all.colour.at(x, y), fixed.colour.at(x, y)) << x << ", " << y;
        break;
      case Mirrored::yes:
        ++mirrored;
        EXPECT_NE(all.colour.at(x, y), fixed.colour.at(x, y)) << x << ", " << y;
        break;
      case Mirrored::border:
        break;
      }
    }
  EXPECT_GT(mirrored, 50);
  EXPECT_GT(others, 500);
}

TEST(EnvironmentObjects, KeepsTheMapWhileDynamicObjectsMove) {
  Scene scene = mirror_and_far_balls();
  Settings settings{.renderer = Renderer::rasterizer};
  settings.environment = Environment::cube_map;
  settings.environment_size = 16;
  Prepared prepared;
  Progress progress;
  const auto map = [&] {
    return raster::environment_maps(scene, settings, prepared, WorkerPriority::normal, progress)->at(mirror);
  };
  const auto move = [&](std::size_t object) {
    const Vec3d before = std::get<Sphere>(scene.geometry->objects[object].shape).centre;
    scene.geometry.edit(
        [&](Geometry& g) { std::get<Sphere>(g.objects[object].shape).centre = before + Vec3d(0.125, 0, 0); });
  };
  for (const EnvironmentObjects choice : {EnvironmentObjects::all, EnvironmentObjects::fixed}) {
    settings.environment_objects = choice;
    auto before = map();
    ASSERT_TRUE(before);
    EXPECT_EQ(before, map()) << "nothing moved";
    EXPECT_EQ(before->left_out, choice == EnvironmentObjects::fixed ? 1 : 0);
    move(moving);
    EXPECT_EQ(before == map(), choice == EnvironmentObjects::fixed);
    for (const std::size_t object : {still, mirror}) {
      before = map();
      move(object);
      EXPECT_NE(before, map()) << "object " << object;
    }
    before = map();
    scene.geometry.edit([](Geometry& g) { g.objects[moving].dynamic = false; });
    EXPECT_NE(before, map()) << "it is static now";
    scene.geometry.edit([](Geometry& g) { g.objects[moving].dynamic = true; });
  }
}

/// A static and a dynamic mirror, a static and a dynamic ball.
Scene two_mirrors() {
  return parse_scene("background = (40, 60, 90)\n"
                     "light { type = ambient intensity = 1 }\n"
                     "sphere { name = m center = (0, 0, 4) radius = 0.4 color = white reflective = 0.8 }\n"
                     "sphere { name = moving center = (1, 0, 4) radius = 0.4 color = white reflective = 0.5 "
                     "dynamic = on }\n"
                     "sphere { name = ball dynamic = on center = (0, 2, 5) radius = 0.5 color = red }\n"
                     "sphere { name = still center = (-2, 0, 5) radius = 0.5 color = green }\n",
                     "two.scene", ".");
}

/// What the maps of the two mirrors are before and after an object has moved.
struct MapsAround {
  Scene scene = two_mirrors();
  Settings settings;
  Prepared prepared;
  Progress progress;

  explicit MapsAround(Environment environment, EnvironmentObjects objects) {
    settings.renderer = Renderer::rasterizer;
    settings.environment = environment;
    settings.environment_objects = objects;
    settings.environment_size = 16;
  }
  std::shared_ptr<const raster::EnvironmentMap> map(std::size_t object) {
    return raster::environment_maps(scene, settings, prepared, WorkerPriority::normal, progress)->at(object);
  }
  void move(std::size_t object) {
    scene.geometry.edit([&](Geometry& g) { std::get<Sphere>(g.objects[object].shape).centre += Vec3d(0.125, 0, 0); });
  }
  /// Which of the two maps are made anew when the object moves.
  std::array<bool, 2> made_anew(std::size_t object) {
    const auto first = map(0), second = map(1);
    move(object);
    return {map(0) != first, map(1) != second};
  }
};

// A dynamic mirror stands in no other mirror's map, so only its own is made anew when it moves.
TEST(EnvironmentObjects, AMovingMirrorChangesNoMapButItsOwn) {
  using Anew = std::array<bool, 2>;
  MapsAround fixed(Environment::cube_map, EnvironmentObjects::fixed);
  EXPECT_EQ(fixed.made_anew(1), (Anew{false, true})) << "the dynamic mirror";
  EXPECT_EQ(fixed.made_anew(2), (Anew{false, false})) << "the dynamic ball";
  EXPECT_EQ(fixed.made_anew(3), (Anew{true, true})) << "the static ball";
  EXPECT_EQ(fixed.made_anew(0), (Anew{true, true})) << "the static mirror, which the other shows";
  MapsAround all(Environment::cube_map, EnvironmentObjects::all);
  for (const std::size_t object : {0u, 1u, 2u, 3u}) EXPECT_EQ(all.made_anew(object), (Anew{true, true})) << object;
  // What is kept is what would be made.
  const auto kept = fixed.map(0);
  fixed.prepared.clear();
  const auto fresh = fixed.map(0);
  ASSERT_NE(kept, fresh);
  for (std::size_t face = 0; face < 6; ++face) EXPECT_TRUE(kept->faces[face] == fresh->faces[face]);
  EXPECT_EQ(fresh->left_out, 2) << "the other mirror and the ball";
  EXPECT_EQ(fixed.map(1)->left_out, 1) << "the ball; a mirror is never in its own map";
}

// Mirrors are not in the map of the room, and with environment-objects = static nothing that is dynamic is.
TEST(EnvironmentObjects, TheMapOfTheRoomFollowsTheMark) {
  using Anew = std::array<bool, 2>;
  MapsAround all(Environment::room_map, EnvironmentObjects::all);
  EXPECT_EQ(all.map(0), all.map(1));
  EXPECT_EQ(all.map(0)->left_out, 0);
  for (const std::size_t mirror_index : {0u, 1u})
    EXPECT_EQ(all.made_anew(mirror_index), (Anew{false, false})) << "mirror " << mirror_index;
  for (const std::size_t ball : {2u, 3u}) EXPECT_EQ(all.made_anew(ball), (Anew{true, true})) << "ball " << ball;
  MapsAround fixed(Environment::room_map, EnvironmentObjects::fixed);
  EXPECT_EQ(fixed.map(0)->left_out, 1);
  EXPECT_EQ(fixed.made_anew(2), (Anew{false, false})) << "the dynamic ball";
  EXPECT_EQ(fixed.made_anew(3), (Anew{true, true})) << "the static ball";
  // The picture is that of a room without the dynamic ball.
  Scene without = fixed.scene;
  without.geometry.edit([](Geometry& g) { g.objects.erase(g.objects.begin() + 2); });
  Settings plain = fixed.settings;
  plain.environment_objects = EnvironmentObjects::all;
  Prepared prepared;
  Progress progress;
  const auto expected = raster::environment_maps(without, plain, prepared, WorkerPriority::normal, progress)->at(0);
  for (std::size_t face = 0; face < 6; ++face) EXPECT_TRUE(fixed.map(0)->faces[face] == expected->faces[face]);
  EXPECT_FALSE(fixed.map(0)->faces[0] == all.map(0)->faces[0] && fixed.map(0)->faces[2] == all.map(0)->faces[2]);
}

TEST(EnvironmentObjects, TheInspectorAndTheCaptionSayWhatIsLeftOut) {
  const Scene scene = load_scene("lab/mirror-room");
  Settings settings{.renderer = Renderer::rasterizer};
  settings.environment = Environment::cube_map;
  settings.environment_size = 32;
  for (const EnvironmentObjects choice : {EnvironmentObjects::all, EnvironmentObjects::fixed}) {
    settings.environment_objects = choice;
    const int expected = choice == EnvironmentObjects::fixed ? 1 : 0;
    const PixelStory story = inspect(scene, {scene.camera, 60, 60}, settings, {30, 33});
    int maps = 0;
    for (const auto* map : events_of<EnvironmentEvent>(story.events)) {
      ++maps;
      EXPECT_EQ(map->left_out, expected);
    }
    EXPECT_EQ(maps, 1);
    const std::string words = left_out_words(scene_traits(scene), settings);
    EXPECT_EQ(words.find("dynamic objects") != std::string::npos, expected == 1) << words;
  }
}

TEST(EnvironmentObjects, TheMarkIsWrittenAndReadBack) {
  const Scene scene = parse_scene(
      "model { name = m vertices { (0, 0, 0) (1, 0, 0) (0, 1, 0) } triangles { (0, 1, 2) } }\n"
      "sphere { dynamic = on center = (0, 0, 0) radius = 1 }\n"
      "box { dynamic = on center = (0, 0, 0) size = 1 }\n"
      "instance { model = m dynamic = on }\n"
      "group { transform { scale = (1, 2, 1) } sphere { center = (0, 0, 0) radius = 1 dynamic = on } }\n"
      "union { dynamic = on sphere { center = (0, 0, 0) radius = 1 } sphere { center = (1, 0, 0) radius = 1 } }\n"
      "sphere { dynamic = off center = (0, 0, 0) radius = 1 }\n",
      "marks.scene", ".");
  const Scene again = parse_scene(write_scene(scene, "."), "again.scene", ".");
  const std::vector<bool> expected{true, true, true, true, true, false};
  ASSERT_EQ(scene.geometry->objects.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(scene.geometry->objects[i].dynamic, expected[i]) << i;
    EXPECT_EQ(again.geometry->objects[i].dynamic, expected[i]) << i;
  }
}

}  // namespace
}  // namespace ps::environment_objects_test
