// Every shader compiles as GLSL 3.30 and as GLSL ES 3.00, in all the variants that options and scenes ask for.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "agreement/hardware/hardware_pair.h"
#include "base/atomic_file.h"
#include "base/check.h"
#include "base/read_file.h"
#include "base/resources.h"
#include "hardware/definitions.h"
#include "hardware/gl_thread.h"
#include "hardware/lacks.h"
#include "hardware/shader_text.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "support/environment.h"
#include "support/run_cli.h"
#include "support/settings_with.h"

namespace ps {
namespace {

constexpr std::array uses{hardware::ProgramUse::picture, hardware::ProgramUse::story};

/// The definitions of all surfaces of a picture.
void add_definitions(const Scene& scene, const Settings& settings, std::set<std::string>& all) {
  Prepared prepared;
  for (const Channel channels : {Channel::none, Channel::ids | Channel::normal}) {
    RenderRequest request;
    request.channels = channels;
    const hardware::PicturePlan plan = hardware::make_plan(scene, {scene.camera, 40, 30}, settings, request, prepared);
    for (const auto& surface : plan.surfaces.list)
      for (const hardware::ProgramUse use : uses) all.insert(hardware::definitions(plan, surface, false, use));
  }
}

/// With each value of each option by itself.
std::set<std::string> all_definitions(Renderer hardware) {
  std::set<std::string> all;
  for (const char* name : {"cgfs/relief", "cgfs/fence", "cgpp/teapot"}) {
    const Scene scene = load_scene(name);
    Settings settings = settings_for(scene, hardware);
    add_definitions(scene, settings, all);
    for (const Option& option : option_table()) {
      if (option.key == "renderer" || hardware::lacks_option(option, settings)) continue;
      const double before = option.get(settings);
      for (const double value : {option.minimum, option.minimum + 1, option.minimum + 2, option.maximum}) {
        if (option.kind == OptionKind::boolean && value > 1) continue;
        if (option.kind != OptionKind::boolean && value > option.maximum) continue;
        if (hardware::lacks_value(option, value, settings)) continue;
        option.set(settings, option.kind == OptionKind::boolean ? 1 - before : value);
        add_definitions(scene, settings, all);
        option.set(settings, before);
      }
    }
  }
  return all;
}

TEST(HardwareShaders, CompileForOpenGlAndForOpenGlEs) {
  PS_NEEDS_HARDWARE(hardware);
  const std::set<std::string> all = all_definitions(hardware);
  EXPECT_GT(all.size(), 30u);
  hardware::on_gl_thread([&](hardware::Workshop&) {
    for (const hardware::Api api : {hardware::Api::desktop, hardware::Api::embedded}) {
      const hardware::Context context(api);
      for (const std::string& definitions : all)
        EXPECT_NO_THROW(hardware::Program("vertex.glsl", "fragment.glsl", api, definitions)) << definitions;
    }
  });
}

TEST(HardwareShaders, ThoseOfPassesCompileForOpenGlAndForOpenGlEs) {
  PS_NEEDS_HARDWARE(hardware);
  std::set<std::string> volumes, deferred;
  for (const char* name : {"cgfs/relief", "cgfs/reflections", "cgpp/teapot"}) {
    const Scene scene = load_scene(name);
    Settings settings = settings_for(scene, hardware);
    parse_assignment("environment=cube-map", settings);
    for (const char* shadows : {"none", "map", "stencil-depth-fail"})
      for (const char* shading : {"phong", "gouraud"})
        for (const char* depth : {"inverse-z", "distance"})
          for (const char* projection : {"perspective", "orthographic"}) {
            for (const auto& [key, value] : {std::pair{"shadows", shadows},
                                             {"shading", shading},
                                             {"depth-value", depth},
                                             {"projection", projection}})
              parse_assignment(std::string(key) + "=" + value, settings);
            Prepared prepared;
            const hardware::PicturePlan plan =
                hardware::make_plan(scene, {scene.camera, 40, 30}, settings, {}, prepared);
            for (const hardware::ProgramUse use : uses) {
              volumes.insert(hardware::volume_definitions(plan, false, use));
              deferred.insert(hardware::deferred_definitions(plan, false, use));
            }
          }
  }
  hardware::on_gl_thread([&](hardware::Workshop&) {
    for (const hardware::Api api : {hardware::Api::desktop, hardware::Api::embedded}) {
      const hardware::Context context(api);
      for (const std::string& definitions : volumes)
        EXPECT_NO_THROW(hardware::Program("volume_vertex.glsl", "volume_fragment.glsl", api, definitions))
            << definitions;
      for (const std::string& definitions : deferred)
        EXPECT_NO_THROW(hardware::Program("whole_picture.glsl", "deferred.glsl", api, definitions)) << definitions;
    }
  });
}

TEST(HardwareShaders, WordsOfAnyDriverNameFileAndLineAlike) {
  const ShaderText shader{"", {"fragment.glsl", "limits.glsl", "lighting.glsl"}};
  const auto words = [&](std::string_view log) { return hardware::compiler_words(shader, log); };
  // Mesa, NVIDIA, and as in the reference compiler.
  EXPECT_EQ(words("0:300015(7): error: syntax error\nmore"), "lighting.glsl:15(7): error: syntax error");
  EXPECT_EQ(words("0(100151) : error C0000: syntax error"), "fragment.glsl:151: error C0000: syntax error");
  EXPECT_EQ(words("ERROR: 0:200008: '' : syntax error"), "limits.glsl:8: error: '' : syntax error");
  for (const char* other : {"out of memory", "0:400001(7): error: no such file", "0:15(7): error: in no file", "2",
                            "0:x", "ERROR: none", ""})
    EXPECT_EQ(words(other), other);
}

TEST(HardwareShaders, AMistakeIsReportedWithFileAndLine) {
  PS_NEEDS_HARDWARE(hardware);
  hardware::on_gl_thread([&](hardware::Workshop& shop) {
    const std::string all = *all_definitions(hardware).begin();
    try {
      // A definition that turns "vec3 own_normal = ..." in vertex.glsl into a syntax error.
      const hardware::Program program("vertex.glsl", "fragment.glsl", shop.context.api(),
                                      all + "#define own_normal 1 +\n");
      FAIL() << "it compiles";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("a shader does not compile: "), std::string::npos) << error.what();
      std::ifstream file(shader_file("vertex.glsl"));
      int row = 1;
      for (std::string line; std::getline(file, line) && line.find("own_normal") == std::string::npos;) ++row;
      EXPECT_NE(std::string(error.what()).find(fmt::format("vertex.glsl:{}(", row)), std::string::npos) << error.what();
    }
  });
}

/// What the driver says of the picture's programs, with the first of these definitions under which one of them does not
/// compile.
std::string refusal(const std::set<std::string>& definitions) {
  std::string words;
  hardware::on_gl_thread([&](hardware::Workshop& shop) {
    try {
      for (const std::string& each : definitions)
        const hardware::Program program("vertex.glsl", "fragment.glsl", shop.context.api(), each);
    } catch (const InputError& error) {
      words = error.what();
    }
  });
  return words;
}

// A name that is not declared is found after parsing, where Mesa knows the line alone and not the number of the file.
TEST(HardwareShaders, AMistakeInAnIncludedFileIsReportedThere) {
  PS_NEEDS_HARDWARE(hardware);
  const std::set<std::string> definitions = all_definitions(hardware);
  const test::ScratchFolder scratch;
  const std::filesystem::path folder = scratch.path() / "core/hardware/shaders", whole = shader_file("");
  std::filesystem::create_directories(folder);
  std::filesystem::copy(whole, folder);
  const test::Variable root("PIXELSCOPE_ROOT", scratch.path().string());
  for (const char* name : {"tints.glsl", "lighting.glsl", "carried.glsl", "texturing.glsl", "power.glsl",
                           "fragment.glsl", "vertex.glsl"}) {
    const std::string text = read_whole_file(whole / name);
    const auto row = std::count(text.begin(), text.end(), '\n') + 1;
    write_file_atomically(folder / name, text + "float mistaken() { return undeclared; }\n");
    const std::string place = std::string(name) + ":" + std::to_string(row);
    EXPECT_NE(refusal(definitions).find("a shader does not compile: " + place), std::string::npos)
        << place << ": " << refusal(definitions);
    write_file_atomically(folder / name, text);
  }
  EXPECT_EQ(refusal(definitions), "");
}

}  // namespace
}  // namespace ps
