// The way of a vertex through the spaces.
#include "inspect/vertex_chain.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/check.h"
#include "options/scene_settings.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "support/render_once.h"
#include "support/settings_with.h"

namespace ps::vertex_chain_test {
namespace {

View view_of(const Scene& scene) { return {scene.camera, scene.canvas_width, scene.canvas_height}; }

/// A corner of the left cube in cgfs/wireframe: (1, 1, -1) moved by (-1.5, 0, 7) is (-0.5, 1, 6), and projects to
/// (-0.5 / 6, 1 / 6) of 600 pixels.
TEST(VertexChain, AgreesWithTheBookByHand) {
  const Scene scene = load_scene("cgfs/wireframe");
  Settings settings;
  settings.precision = Precision::float64;
  const VertexChain chain = vertex_chain(scene, view_of(scene), settings, {0, 4});
  EXPECT_EQ(chain.model, Vec3d(1, 1, -1));
  EXPECT_EQ(chain.world, Vec3d(-0.5, 1, 6));
  EXPECT_EQ(chain.camera, Vec3d(-0.5, 1, 6));
  EXPECT_NEAR(chain.viewport.x, -0.5 / 6, 1e-15);
  EXPECT_NEAR(chain.centred.x, -50, 1e-12);
  EXPECT_NEAR(chain.centred.y, 100, 1e-12);
  EXPECT_NEAR(chain.canvas.x, 250, 1e-12);
  EXPECT_NEAR(chain.canvas.y, 200, 1e-12);
  EXPECT_TRUE(chain.inside);
  EXPECT_NEAR(chain.clip.x / chain.clip.w, chain.centred.x, 1e-12);
}

/// The matrices are the same way: model through all of them is the canvas place.
TEST(VertexChain, MatricesLeadToTheSamePlace) {
  for (const char* name : {"cgfs/cubes", "cgfs/shading", "cgfs/crates"}) {
    const Scene scene = load_scene(name);
    Settings settings;
    settings.precision = Precision::float64;
    for (int object = 0; object < 2; ++object)
      for (int vertex = 0; vertex < 8; ++vertex)
        for (const ModelOrder order : {ModelOrder::turn_then_move, ModelOrder::move_then_turn}) {
          const VertexChain chain = vertex_chain(scene, view_of(scene), settings, {object, vertex}, {order, {}});
          const Vec4d clip = chain.to_clip * chain.to_camera * chain.to_world * Vec4d(chain.model, 1);
          EXPECT_NEAR(clip.x / clip.w, chain.centred.x, 1e-9);
          EXPECT_NEAR(clip.y / clip.w, chain.centred.y, 1e-9);
        }
  }
}

/// The corners that the rasterizer reports for a fragment are where the chain says.
TEST(VertexChain, CornersOfFragmentsAreItsPlaces) {
  const Scene scene = load_scene("cgfs/crates");
  Settings settings = settings_for(scene, Renderer::rasterizer);
  int compared = 0;
  for (const Vec2i pixel : {Vec2i(340, 130), Vec2i(180, 330), Vec2i(440, 150)}) {
    const PixelStory story = inspect(scene, view_of(scene), settings, pixel);
    for (const auto* fragment : events_of<FragmentEvent>(story.events)) {
      if (fragment->clipped_into != 1) continue;
      const auto& instance =
          std::get<Instance>(scene.geometry->objects.at(static_cast<std::size_t>(fragment->id.object)).shape);
      const MeshTriangle& triangle =
          scene.geometry->meshes[instance.mesh]->triangles.at(static_cast<std::size_t>(fragment->id.triangle));
      for (std::size_t k = 0; k < 3; ++k) {
        const VertexChain chain = vertex_chain(scene, view_of(scene), settings,
                                               {fragment->id.object, static_cast<int>(triangle.position[k])});
        // Corners snap to 1/256 of a pixel.
        EXPECT_NEAR(chain.canvas.x, fragment->corners[k].x, 1.0 / 256);
        EXPECT_NEAR(chain.canvas.y, fragment->corners[k].y, 1.0 / 256);
        EXPECT_NEAR(chain.camera.z, fragment->corner_depth[k], 1e-6);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 8);
}

TEST(VertexChain, EditsChangeTheirStep) {
  const Scene scene = load_scene("cgfs/cubes");
  const Settings settings;
  const VertexChain plain = vertex_chain(scene, view_of(scene), settings, {1, 0});
  const VertexChain moved_first =
      vertex_chain(scene, view_of(scene), settings, {1, 0}, {ModelOrder::move_then_turn, {}});
  EXPECT_EQ(moved_first.model, plain.model);
  EXPECT_GT(std::abs(moved_first.world.x - plain.world.x), 0.5);
  EXPECT_TRUE(plain.inside);
  const VertexChain near = vertex_chain(scene, view_of(scene), settings, {1, 0}, {ModelOrder::turn_then_move, 100.0});
  EXPECT_FALSE(near.inside);
  EXPECT_EQ(near.canvas, plain.canvas);
  ASSERT_FALSE(near.planes.empty());
  EXPECT_EQ(near.planes[0].plane, "near plane");
  EXPECT_LT(near.planes[0].distance, 0);
}

TEST(VertexChain, NearestVertexIsWhereItIsDrawn) {
  const Scene scene = load_scene("cgfs/wireframe");
  const auto id = nearest_vertex(scene, view_of(scene), Settings{}, {251, 199});
  ASSERT_TRUE(id);
  EXPECT_EQ(*id, (VertexId{0, 4}));
  // Among the corners of one triangle only: the nearest of 0, 1, 2.
  const auto corner = nearest_vertex(scene, view_of(scene), Settings{}, {251, 199}, PixelId{0, 0});
  ASSERT_TRUE(corner);
  EXPECT_EQ(corner->object, 0);
  EXPECT_LE(corner->vertex, 2);
  EXPECT_FALSE(nearest_vertex(load_scene("cgfs/spheres"), view_of(scene), Settings{}, {10, 10}));
}

TEST(VertexChain, RefusesWhatIsNoVertex) {
  const Scene cubes = load_scene("cgfs/cubes"), spheres = load_scene("cgfs/spheres");
  EXPECT_THROW(vertex_chain(cubes, view_of(cubes), {}, {7, 0}), InputError);
  EXPECT_THROW(vertex_chain(cubes, view_of(cubes), {}, {0, 8}), InputError);
  EXPECT_THROW(vertex_chain(cubes, view_of(cubes), {}, {-1, -1}), InputError);
  EXPECT_THROW(vertex_chain(spheres, view_of(spheres), {}, {0, 0}), InputError);
}

}  // namespace
}  // namespace ps::vertex_chain_test
