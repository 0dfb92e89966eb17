// The shaders that drew a pixel are listed as the driver has them; what becomes of files that are written anew.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "agreement/hardware/hardware_pair.h"
#include "base/atomic_file.h"
#include "base/check.h"
#include "base/resources.h"
#include "hardware/gl_thread.h"
#include "hardware/shader_listing.h"
#include "hardware/shader_text.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "support/environment.h"
#include "support/render_once.h"
#include "support/run_cli.h"
#include "support/settings_with.h"

namespace ps::shader_listing_test {
namespace {

Settings drawn_by(Renderer hardware, const Scene& scene, const std::vector<std::string>& assignments = {}) {
  return settings_with(settings_for(scene, hardware), assignments);
}

std::shared_ptr<const ShaderListing> listing_at(const Scene& scene, const Settings& settings, Vec2i pixel) {
  Prepared prepared;
  Progress progress;
  return hardware::list_shaders(scene, {scene.camera, 120, 120}, settings, pixel, prepared, progress);
}

std::vector<std::string> texts_of(const ShaderDraw& draw) {
  return {text_of(draw.shaders, ShaderStage::vertex).text, text_of(draw.shaders, ShaderStage::fragment).text};
}

TEST(ShaderListing, IsTheTextOfTheProgramsThatDraw) {
  PS_NEEDS_HARDWARE(hardware);
  const Scene scene = load_scene("cgfs/reflections");
  const View view{scene.camera, 120, 120};
  std::set<std::string> seen;
  for (const char* assignment : {"shading=phong", "shading=flat", "lighting=off", "deferred-shading=on"}) {
    const Settings settings = drawn_by(hardware, scene, {assignment});
    const Frame frame = render(scene, view, settings);  // its programs are those of the listing
    const auto listing = listing_at(scene, settings, {60, 70});
    ASSERT_EQ(listing->draws.size(), settings.deferred_shading ? 2u : 1u);
    std::set<std::vector<std::string>> made;
    hardware::on_gl_thread([&](hardware::Workshop& shop) {
      const auto text = [&](const std::string& file, ShaderStage stage, const std::string& definitions) {
        return hardware::shader_text(shop.shaders, file, stage, shop.context.api(), definitions).text;
      };
      for (const auto& [key, kept] : shop.programs)
        made.insert({text(kept.vertex_file, ShaderStage::vertex, kept.definitions),
                     text(kept.fragment_file, ShaderStage::fragment, kept.definitions)});
    });
    for (const ShaderDraw& draw : listing->draws) {
      EXPECT_TRUE(made.contains(texts_of(draw))) << assignment;
      seen.insert(texts_of(draw)[1]);
    }
  }
  EXPECT_EQ(seen.size(), 5u) << "each of the settings has programs of its own";
}

TEST(ShaderListing, IsOfThePickedTriangle) {
  PS_NEEDS_HARDWARE(hardware);
  const Scene scene = load_scene("cgfs/reflections");
  const Settings settings = drawn_by(hardware, scene);
  const View view{scene.camera, 120, 120};
  const Frame frame = render(scene, view, settings, request_for(Channel::ids));
  std::set<int> objects;
  for (int y = 5; y < 120; y += 23)
    for (int x = 5; x < 120; x += 23) {
      const PixelId seen = frame.ids.at(x, y);
      const auto listing = listing_at(scene, settings, {x, y});
      ASSERT_EQ(listing->draws.size(), seen.object < 0 ? 0u : 1u) << x << "," << y;
      if (seen.object < 0) continue;
      EXPECT_EQ(listing->draws.front().id.object, seen.object);
      EXPECT_NE(texts_of(listing->draws.front())[1].find(fmt::format("#define LIGHTS {}\n", scene.lights->size())),
                std::string::npos);
      objects.insert(seen.object);
    }
  EXPECT_GE(objects.size(), 3u) << "several objects were looked at";
}

TEST(ShaderListing, HasADrawForEachProgram) {
  PS_NEEDS_HARDWARE(hardware);
  const Scene scene = load_scene("cgfs/shadows");
  const auto passes = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all;
    const auto listing = listing_at(scene, drawn_by(hardware, scene, more), {60, 70});
    for (const ShaderDraw& draw : listing->draws) all.push_back(draw.pass + ":" + draw.shaders[1].files.front());
    return all;
  };
  EXPECT_EQ(passes({"shadows=stencil-depth-fail"}), std::vector<std::string>{":fragment.glsl"});
  EXPECT_EQ(passes({"shadows=none", "deferred-shading=on"}),
            (std::vector<std::string>{"what deferred shading reads:fragment.glsl", "shading:deferred.glsl"}));
}

/// A folder of shaders of its own, that the renderer reads while this lives.
class OwnShaders {
 public:
  OwnShaders() {
    std::filesystem::create_directories(folder_.path() / "core/hardware");
    std::filesystem::copy(shader_file(""), shaders());
    variable_.emplace("PIXELSCOPE_ROOT", folder_.path().string());
  }
  ~OwnShaders() {
    variable_.reset();
    hardware::reload_shaders();
  }
  std::filesystem::path shaders() const { return folder_.path() / "core/hardware/shaders"; }
  void replace(const std::string& file, const std::string& what, const std::string& by) const {
    std::string text = read_whole_file(shaders() / file);
    const std::size_t at = text.find(what);
    ASSERT_NE(at, std::string::npos);
    write_file_atomically(shaders() / file, text.replace(at, what.size(), by));
  }

 private:
  test::ScratchFolder folder_;
  std::optional<test::Variable> variable_;
};

TEST(ShaderReload, KeepsTheLastGoodProgramAndNamesTheLine) {
  PS_NEEDS_HARDWARE(hardware);
  const Scene scene = load_scene("cgfs/spheres");
  const Settings settings = drawn_by(hardware, scene);
  const auto draw = [&](const Settings& how) { return render(scene, {scene.camera, 60, 60}, how).colour; };
  const OwnShaders own;
  ASSERT_EQ(hardware::reload_shaders(), "");
  const Image<Vec3f> before = draw(settings);

  own.replace("fragment.glsl", "vec3 colour = surface_colour;", "vec3 colour = surface_colour +;");
  const std::string message = hardware::reload_shaders();
  const std::string text = read_whole_file(own.shaders() / "fragment.glsl");
  const auto line =
      std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find("surface_colour +;")), '\n') + 1;
  EXPECT_NE(message.find(fmt::format("fragment.glsl:{}", line)), std::string::npos) << message;
  EXPECT_EQ(draw(settings), before) << "the last good program stays in use";
  Settings unlit = settings;
  unlit.lighting = !unlit.lighting;
  EXPECT_NO_THROW(draw(unlit)) << "a program that was not there yet is made of the texts that are in use";

  own.replace("fragment.glsl", "surface_colour +;", "surface_colour.zxy;");
  EXPECT_EQ(hardware::reload_shaders(), "");
  const Image<Vec3f> after = draw(settings);
  EXPECT_NE(after, before);
  // Red, green and blue have changed their places, so that unlit levels are those of before.
  const Image<Vec3f> turned = draw(unlit);
  own.replace("fragment.glsl", "surface_colour.zxy;", "surface_colour;");
  EXPECT_EQ(hardware::reload_shaders(), "");
  const Image<Vec3f> plain = draw(unlit);
  int seen = 0;
  for (std::size_t i = 0; i < plain.pixels().size(); ++i) {
    const Vec3f p = plain.pixels()[i];
    if (p == Vec3f(scene.background)) continue;
    EXPECT_EQ(turned.pixels()[i], Vec3f(p.z, p.x, p.y));
    ++seen;
  }
  EXPECT_GT(seen, 500);
  EXPECT_EQ(draw(settings), before);
}

}  // namespace
}  // namespace ps::shader_listing_test
