// A pixel's story draws the triangles near it and only counts the others: as the picture does, whatever becomes of
// them.
#include <gtest/gtest.h>

#include <array>

#include "scene/load.h"
#include "support/render_once.h"

namespace ps::far_triangles_test {
namespace {

constexpr std::array counted{Counter::objects_culled,         Counter::triangles_in,    Counter::triangles_degenerate,
                             Counter::triangles_backfacing,   Counter::triangles_split, Counter::triangles_drawn,
                             Counter::triangles_clipped_away, Counter::lines_drawn};

struct Look {
  const char* scene;
  Vec3d from;  ///< where the scene's camera goes, seen from where it stands
};

TEST(FarTriangles, AreCountedAsInThePicture) {
  for (const Look& look : {Look{"cgpp/teapot", {0, 0, 0}}, Look{"cgpp/teapot", {0.5, 0.2, -4}},
                           Look{"cgfs/shading", {0, 0, 1.5}}, Look{"cgfs/crates", {0.5, 0, 5}}})
    for (const Clipping clipping : {Clipping::full, Clipping::near_only, Clipping::none})
      for (const bool culling : {true, false})
        for (const Shading shading : {Shading::phong, Shading::gouraud}) {
          const Scene scene = load_scene(look.scene);
          View view{scene.camera, 96, 60};
          const Camera& camera = scene.camera;
          view.camera.position += camera.right * look.from.x + camera.up * look.from.y + camera.forward * look.from.z;
          Settings settings{.renderer = Renderer::rasterizer};
          settings.clipping = clipping;
          settings.backface_culling = culling;
          settings.shading = shading;
          const Frame fast = render(scene, view, settings);
          settings.simd = Simd::off;
          const Frame clear = render(scene, view, settings);
          for (const Vec2i pixel : {Vec2i{48, 30}, Vec2i{80, 41}}) {
            const PixelStory story = inspect(scene, view, settings, pixel);
            for (const Counter counter : counted) {
              EXPECT_EQ(story.counters[counter], clear.counters[counter]) << look.scene << " " << counter_key(counter);
              EXPECT_EQ(fast.counters[counter], clear.counters[counter]) << look.scene << " " << counter_key(counter);
            }
          }
        }
}

}  // namespace
}  // namespace ps::far_triangles_test
