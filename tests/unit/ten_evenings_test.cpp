// The lesson "Your renderer in ten evenings": routines that were written in earlier lessons fit into the programs of
// later ones as its text says, and are what then draws.
#include <gtest/gtest.h>

#include "engine/lesson.h"
#include "student/check_listing.h"
#include "support/own_listings.h"

namespace ps::ten_evenings_test {
namespace {

std::string copy_of(std::string_view folder, std::string_view without = {}) {
  return listing_copy(test::listing_in(folder), without);
}

/// The whole text of a routine in a copy, from its first line to its closing brace.
std::string routine_in(const std::string& text, const std::string& name) {
  for (std::size_t at = text.find(name + "("); at != std::string::npos; at = text.find(name + "(", at + 1)) {
    const std::size_t line = text.rfind('\n', at) + 1;
    if (text[line] == ' ') continue;  // a call
    return text.substr(line, text.find("\n}\n", at) + 3 - line);
  }
  throw InputError("no routine '" + name + "'");
}

std::string with_routine(const std::string& text, const std::string& name, const std::string& routine) {
  return test::with_change(text, routine_in(text, name), routine);
}

/// Pixels that differ from the listing's, in the scene of an evening.
std::size_t wrong_pixels_of(const std::string& text, std::string_view folder, int evening) {
  test::OwnListings own;
  CompileOptions options;
  options.limits.seconds = 120;  // a busy machine makes no picture wrong
  const Compilation compiled = own.compile(text, options);
  for (const CompilerMessage& message : compiled.messages) ADD_FAILURE() << message.line << ": " << message.text;
  if (!compiled.program) throw InputError(compiled.failure);
  Document document = lesson_document(load_lesson("your_renderer_in_ten_evenings"), evening, Document{});
  document.view.width = 240;
  document.view.height = 180;
  Progress progress;
  const CheckedListing checked = check_listing(*compiled.program, test::listing_in(folder), document.scene,
                                               view_of(document), document.a.settings, {}, progress);
  EXPECT_EQ(checked.run.failure, "");
  return checked.wrong.count;
}

TEST(TenEvenings, TheSecondTakesTheFirstsRoutineAsItIsAndTheLightWithoutItsShadows) {
  const std::string folder = "cgfs_04_shadows_and_reflections";
  const std::string name = "intersect_ray_sphere";
  const std::string first =
      with_routine(copy_of(folder, name), name, routine_in(copy_of("cgfs_02_basic_ray_tracing"), name));
  EXPECT_EQ(wrong_pixels_of(first, folder, 2), 0u);
  const std::string light = routine_in(copy_of("cgfs_03_light"), "compute_lighting");
  EXPECT_GT(wrong_pixels_of(with_routine(first, "compute_lighting", light), folder, 2), 0u);
}

/// The evenings' routines in the program of the last one, with this *interpolate* for numbers.
std::string last_program(const std::string& interpolate) {
  std::string vectors = interpolate;
  for (const auto& [from, to] : {std::pair("std::vector<double> interpolate", "std::vector<Vec3d> interpolate"),
                                 {"double d0", "const Vec3d& d0"},
                                 {"double d1", "const Vec3d& d1"},
                                 {"std::vector<double> values", "std::vector<Vec3d> values"},
                                 {"const double a", "const Vec3d a"},
                                 {"double d = d0", "Vec3d d = d0"}})
    vectors = test::with_change(vectors, from, to);
  std::string text =
      with_routine(copy_of("cgfs_14_textures"), "unproject", routine_in(copy_of("cgfs_13_shading"), "unproject"));
  const std::string project = routine_in(text, "project");
  text = test::with_change(text, project,
                           interpolate + vectors + routine_in(copy_of("cgfs_10_scenes"), "model_to_camera") + project);
  return test::with_change(text, "world_to_camera(scene.camera) * to_world;", "model_to_camera(scene, t);");
}

TEST(TenEvenings, TheLastTakesThemAll) {
  const std::string interpolate = routine_in(copy_of("cgfs_06_lines"), "interpolate");
  EXPECT_EQ(wrong_pixels_of(last_program(interpolate), "cgfs_14_textures", 10), 0u);
  const std::string steeper = test::with_change(interpolate, "d += a;", "d += a * 1.01;");
  EXPECT_GT(wrong_pixels_of(last_program(steeper), "cgfs_14_textures", 10), 0u);
}

}  // namespace
}  // namespace ps::ten_evenings_test
