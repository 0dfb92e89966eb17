// A solid made by CSG is traced and not rasterized, and that is what the parting of the two says.
#include <gtest/gtest.h>

#include "inspect/parting/parting.h"
#include "options/scene_settings.h"
#include "render/left_out.h"
#include "scene/load.h"
#include "support/render_once.h"

namespace ps::parting_csg_test {
namespace {

TEST(PartingCsg, TheRasterizerDoesNotDrawIt) {
  const Scene scene = load_scene("cgfs/lens");
  const View view{scene.camera, 600, 600};
  Settings traced = settings_for(scene), drawn = traced;
  traced.renderer = Renderer::ray_tracer;
  drawn.renderer = Renderer::rasterizer;
  ASSERT_FALSE(left_out(scene_traits(scene), drawn).empty());
  const PixelStory a = inspect(scene, view, traced, {300, 300});
  const PixelStory b = inspect(scene, view, drawn, {300, 300});
  const Parting parting = find_parting(scene, {a, traced}, {b, drawn});
  EXPECT_NE(parting.sentence.find("leave out CSG objects"), std::string::npos) << parting.sentence;
  EXPECT_EQ(parting.sentence.find("flat triangles"), std::string::npos) << parting.sentence;
}

}  // namespace
}  // namespace ps::parting_csg_test
