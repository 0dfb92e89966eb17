// What the listing says of the shaders that drew a pixel: which lines the compiler has, against the driver's own
// compiler; the values of uniforms, against the scene; and what becomes of files that are written anew.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "agreement/hardware/hardware_pair.h"
#include "base/atomic_file.h"
#include "base/check.h"
#include "base/resources.h"
#include "hardware/condition.h"
#include "hardware/definitions.h"
#include "hardware/gl_thread.h"
#include "hardware/shader_lines.h"
#include "hardware/shader_listing.h"
#include "hardware/uniform_values.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/environment.h"
#include "support/run_cli.h"

namespace shader_listing_test {
namespace {

using namespace ps;

Settings drawn_by(Renderer hardware, const Scene& scene, const std::vector<std::string>& assignments = {}) {
  Settings settings = settings_for(scene);
  settings.renderer = hardware;
  for (const std::string& assignment : assignments) parse_assignment(assignment, settings);
  return settings;
}

std::shared_ptr<const ShaderListing> listing_at(const Scene& scene, const Settings& settings, Vec2i pixel) {
  Prepared prepared;
  Progress progress;
  return hardware::list_shaders(scene, {scene.camera, 120, 120}, settings, pixel, prepared, progress);
}

std::string value_in(const ShaderDraw& draw, ShaderPart part, std::string_view name) {
  for (const ShaderFile& file : draw.files[static_cast<std::size_t>(part)])
    for (const ShaderLine& line : file.lines)
      for (const ShaderValue& value : line.values)
        if (value.name == name) return value.value;
  return "";
}

TEST(ShaderConditions, AreDecidedByPrecedence) {
  const hardware::Definitions d{{"A", 1}, {"B", 2}, {"NONE", 0}};
  for (const char* text : {"A", "B == 2", "!NONE", "A || B && NONE", "(A || NONE) && B", "B % 2 == 0", "A < B",
                           "!MISSING", "A != B", "B >= 2 && A <= 1", "!(A == B)"})
    EXPECT_TRUE(hardware::condition_holds(text, d)) << text;
  for (const char* text : {"NONE", "A == B", "!A", "(A || B) && NONE", "B % 2", "A > B", "MISSING", "!A == 1"})
    EXPECT_FALSE(hardware::condition_holds(text, d)) << text;
  for (const char* text : {"", "A &&", "(A", "A B", "A ? B : 0", "2x", "A % 0"})
    EXPECT_THROW(hardware::condition_holds(text, d), InputError) << text;
  EXPECT_EQ(hardware::names_in("A == 1 && !B || A"), (std::vector<std::string>{"A", "B"}));
}

/// A shader made of nothing but the lines that the listing calls compiled, without any condition: if it calls a wrong
/// line compiled, or leaves one out, the driver does not compile it or another set of uniforms is left.
std::string without_conditions(const std::string& name, const std::string& definitions) {
  hardware::ShaderFiles files;
  std::string text;
  const std::vector<ShaderFile> read = hardware::shader_lines(files, name, definitions, {});
  const auto add = [&](const auto& self, const ShaderFile& file, std::set<std::string>& done) -> void {
    done.insert(file.name);
    for (const ShaderLine& line : file.lines) {
      if (!line.compiled) continue;
      if (line.text.starts_with("#include")) {
        for (const ShaderFile& other : read)
          if (line.text.find("\"" + other.name + "\"") != std::string::npos && !done.contains(other.name))
            self(self, other, done);
      } else if (!line.text.starts_with("#") || line.text.starts_with("#define")) {
        text += line.text + "\n";
      }
    }
  };
  std::set<std::string> done;
  add(add, read.front(), done);
  return text;
}

TEST(ShaderLines, AreThoseThatTheDriversCompilerHas) {
  PS_NEEDS_HARDWARE(hardware);
  const test::ScratchFolder folder;
  const std::filesystem::path shaders = folder.path() / "core/hardware/shaders";
  std::filesystem::create_directories(shaders);
  int programs = 0;
  for (const char* name : {"cgfs/relief", "cgfs/shadows", "cgpp/teapot", "cgfs/crates"})
    for (const std::vector<std::string>& more :
         std::vector<std::vector<std::string>>{{},
                                               {"shading=gouraud"},
                                               {"shading=flat"},
                                               {"lighting=off"},
                                               {"shadows=map"},
                                               {"textures=off"},
                                               {"texture-filter=nearest"},
                                               {"depth-value=distance", "depth-format=unorm"},
                                               {"interpolation=affine"}}) {
      const Scene scene = load_scene(name);
      Prepared prepared;
      const hardware::PicturePlan plan =
          hardware::make_plan(scene, {scene.camera, 40, 30}, drawn_by(hardware, scene, more), {}, prepared);
      const std::string definitions = hardware::definitions(plan, plan.surfaces.list.front(), false);
      write_file_atomically(shaders / "plain_vertex.glsl", without_conditions("vertex.glsl", definitions));
      write_file_atomically(shaders / "plain_fragment.glsl", without_conditions("fragment.glsl", definitions));
      const auto names = [](const hardware::Program& program) {
        std::set<std::string> all;
        for (const auto& [uniform, value] : hardware::uniform_values(program)) all.insert(uniform);
        return all;
      };
      hardware::on_gl_thread([&](hardware::Workshop& shop) {
        const hardware::Program real("vertex.glsl", "fragment.glsl", shop.context.api(), definitions);
        const test::Variable root("PIXELSCOPE_ROOT", folder.path().string());
        std::unique_ptr<hardware::Program> plain;
        ASSERT_NO_THROW(plain = std::make_unique<hardware::Program>("plain_vertex.glsl", "plain_fragment.glsl",
                                                                    shop.context.api(), definitions))
            << name << " " << fmt::format("{}", fmt::join(more, " "));
        EXPECT_EQ(names(*plain), names(real)) << name;
      });
      ++programs;
    }
  EXPECT_EQ(programs, 36);
}

TEST(ShaderListing, HasTheUniformsOfThePickedTriangle) {
  PS_NEEDS_HARDWARE(hardware);
  const Scene scene = load_scene("cgfs/reflections");
  const Settings settings = drawn_by(hardware, scene);
  const View view{scene.camera, 120, 120};
  RenderRequest request;
  request.channels = Channel::ids;
  Prepared prepared;
  Progress progress;
  const Frame frame = render(scene, view, settings, request, prepared, progress);
  std::set<std::string> colours;
  int tried = 0;
  for (int y = 5; y < 120; y += 23)
    for (int x = 5; x < 120; x += 23) {
      const PixelId seen = frame.ids.at(x, y);
      const auto listing = listing_at(scene, settings, {x, y});
      if (seen.object < 0) {
        EXPECT_TRUE(listing->draws.empty()) << x << "," << y;
        continue;
      }
      ASSERT_EQ(listing->draws.size(), 1u);
      const ShaderDraw& draw = listing->draws.front();
      EXPECT_EQ(draw.id.object, seen.object);
      const Object& object = (*scene.geometry).objects[static_cast<std::size_t>(seen.object)];
      const auto& sphere = std::get<Sphere>(object.shape);
      const Material& material = (*scene.materials)[static_cast<std::size_t>(sphere.material)];
      const Vec3f colour(material.colour);
      EXPECT_EQ(value_in(draw, ShaderPart::fragment, "surface_colour"),
                fmt::format("{:.6g}, {:.6g}, {:.6g}", colour.x, colour.y, colour.z));
      EXPECT_EQ(value_in(draw, ShaderPart::fragment, "object_number"), "not used by this program") << "no channels";
      EXPECT_EQ(value_in(draw, ShaderPart::fragment, "LIGHTS"), fmt::format("{}", scene.lights->size()));
      colours.insert(value_in(draw, ShaderPart::fragment, "surface_colour"));
      ++tried;
    }
  EXPECT_GE(tried, 8);
  EXPECT_GE(colours.size(), 3u) << "several objects were looked at";
}

TEST(ShaderListing, HasADrawCallForEachPass) {
  PS_NEEDS_HARDWARE(hardware);
  const Scene scene = load_scene("cgfs/shadows");
  const auto passes = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all;
    const auto listing = listing_at(scene, drawn_by(hardware, scene, more), {60, 70});
    for (const ShaderDraw& draw : listing->draws) all.push_back(draw.pass + ":" + draw.files[1].front().name);
    return all;
  };
  EXPECT_EQ(passes({"shadows=none"}), std::vector<std::string>{":fragment.glsl"});
  EXPECT_EQ(passes({"shadows=none", "deferred-shading=on"}),
            (std::vector<std::string>{"what deferred shading reads:fragment.glsl", "shading:deferred.glsl"}));
  const auto by_light = listing_at(scene, drawn_by(hardware, scene, {"shadows=stencil-depth-fail"}), {60, 70});
  std::vector<std::string> lights;
  for (const ShaderDraw& draw : by_light->draws)
    if (draw.pass.starts_with("light ")) lights.push_back(value_in(draw, ShaderPart::fragment, "light_number"));
  EXPECT_GE(lights.size(), 2u);
  for (std::size_t i = 1; i < lights.size(); ++i) EXPECT_NE(lights[i], lights[i - 1]);
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
}  // namespace shader_listing_test
