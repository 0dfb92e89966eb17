#include <gtest/gtest.h>

#include <random>

#include "frame/display_frame.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "support/environment.h"
#include "support/random_scene.h"
#include "support/random_settings.h"
#include "support/render_once.h"
#include "support/same_bits.h"
#include "support/trials.h"

namespace ps::prepared_walk_test {
namespace {

using ps::test::same_bits;

constexpr int walks = test::trials(500);
constexpr int steps = 4;

using Random = std::mt19937;
using test::below;
using test::random_value;
using test::share;

void move_object(Scene& scene, Random& random) {
  const Vec3d offset{share(random) - 0.5, share(random) - 0.5, share(random) - 0.5};
  scene.geometry.edit([&](Geometry& geometry) {
    Object& object =
        geometry.objects[static_cast<std::size_t>(below(random, static_cast<int>(geometry.objects.size())))];
    if (auto* sphere = std::get_if<Sphere>(&object.shape))
      sphere->centre += offset;
    else if (auto* instance = std::get_if<Instance>(&object.shape))
      instance->transform.translation += offset;
    else if (auto* solid = std::get_if<Solid>(&object.shape))
      solid->material = 0;
  });
}

/// One random edit of the scene; each part of it can be the one that changes.
void edit(Scene& scene, Random& random) {
  switch (below(random, 4)) {
  case 0:
    return move_object(scene, random);
  case 1:
    return scene.lights.edit([&](std::vector<Light>& lights) {
      if (!lights.empty())
        lights[static_cast<std::size_t>(below(random, static_cast<int>(lights.size())))].intensity = share(random);
    });
  case 2:
    return scene.materials.edit([&](std::vector<Material>& materials) {
      if (materials.empty()) return;
      Material& material = materials[static_cast<std::size_t>(below(random, static_cast<int>(materials.size())))];
      material.colour = {share(random), share(random), share(random)};
      material.reflective = share(random);
    });
  case 3:
    scene.camera.position += Vec3d{share(random) - 0.5, share(random) - 0.5, share(random) - 0.5};
    return;
  }
}

Frame frame(const Scene& scene, const View& view, const Settings& settings, Prepared& prepared) {
  Progress progress;
  return render(scene, view, settings, request_for(Channel::depth | Channel::ids), prepared, progress);
}

// The metamorphic test of Prepared: whatever was rendered before, a picture made with what is kept from it equals one
// made from nothing. A product whose key leaves out something that it reads fails here.
TEST(Prepared, KeepsNothingStaleOnRandomWalks) {
  const unsigned seed = test::test_seed();
  RecordProperty("seed", std::to_string(seed));
  SCOPED_TRACE("PIXELSCOPE_TEST_SEED=" + std::to_string(seed));
  Random random(seed);
  const auto table = option_table();
  const std::vector<Scene> scenes{load_scene("cgfs/reflections"), load_scene("cgfs/crates"), load_scene("cgfs/depth"),
                                  test::random_scene(seed)};
  for (int walk = 0; walk < walks; ++walk) {
    Scene scene = scenes[static_cast<std::size_t>(walk) % scenes.size()];
    Settings settings = settings_for(scene);
    settings.threads = 1;
    settings.renderer = walk / 4 % 2 == 0 ? Renderer::ray_tracer : Renderer::rasterizer;
    Prepared kept;
    std::string trace;
    for (int step = 0; step < steps; ++step) {
      if (below(random, 3) == 0) {
        edit(scene, random);
        trace += " edit";
      } else {
        const Option& option = table[static_cast<std::size_t>(below(random, static_cast<int>(table.size())))];
        option.set(settings, random_value(option, random));
        trace += " " + std::string(option.key) + "=" + option_text(option, settings);
      }
      const View view{scene.camera, 20 + 4 * below(random, 2), 16};
      const Frame with = frame(scene, view, settings, kept);
      Prepared nothing;
      const Frame without = frame(scene, view, settings, nothing);
      ASSERT_TRUE(same_bits(with.colour, without.colour)) << scene.name << trace;
      ASSERT_TRUE(same_bits(with.depth, without.depth)) << scene.name << trace;
      ASSERT_EQ(with.ids, without.ids) << scene.name << trace;
      ASSERT_EQ(with.counters, without.counters) << scene.name << trace;
    }
  }
}

}  // namespace
}  // namespace ps::prepared_walk_test
