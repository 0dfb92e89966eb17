#include <array>

#include <fmt/format.h>

#include "scene/scene_file.h"
#include "study/stability/support.h"

namespace ps::stability::guards_at_a_surface {
namespace {

/// The light's direction is half a unit across for each unit up, so a wall shades half of its height.
constexpr double wall_height = 1.25, light_across = 0.5;

/// Where the middle of the first pixel of `side` is, and how far it is to the next: the floor is 2 wide.
double across_floor(int pixel, int side) { return 2 * (pixel + 0.5) / side - 1; }

std::string vec3(const Vec3d& v, double size) {
  return fmt::format("({}, {}, {})", v.x * size, v.y * size, v.z * size);
}

/// Looks straight down from two units above the floor of a well, at y = 0.3, which fills the picture. All lengths are
/// multiplied by `size`, so any guard that knows no length of its own sees the same scene.
std::string above_the_well(double size) {
  return fmt::format("viewport_size = 1 x 1\nprojection_plane_d = 1\nbackground = black\n"
                     "camera {{ position = {}  forward = (0, -1, 0)  up = (0, 0, 1)  right = (1, 0, 0) }}\n"
                     "light {{ type = directional  intensity = 1  direction = ({}, 1, 0) }}\n",
                     vec3({0, 2.3, 0}, size), light_across);
}

/// A brick with a hole: one solid, of which a ray that leaves it can meet another wall.
std::string solid_well(double size) {
  return above_the_well(size) + fmt::format("difference {{\n  box {{ center = {}  size = {}  color = white }}\n"
                                            "  box {{ center = {}  size = {}  color = white }}\n}}\n",
                                            vec3({0, 0.55, 0}, size),
                                            vec3({3, 2 * (0.3 + wall_height - 0.55), 3}, size),
                                            vec3({0, 0.3 + wall_height, 0}, size), vec3({2, 2 * wall_height, 2}, size));
}

/// The same floor and the wall that shades it, each of two triangles.
std::string mesh_well(double size) {
  return above_the_well(size) +
         fmt::format("model {{ name = well\n  vertices {{ 0 = {} 1 = {} 2 = {} 3 = {} 4 = {} 5 = {} }}\n"
                     "  triangles {{ 0 = {{ vertices = [0, 1, 2] color = white }} 1 = {{ vertices = [0, 2, 3] color = "
                     "white }} 2 = {{ vertices = [3, 2, 4] color = white }} 3 = {{ vertices = [3, 4, 5] color = white "
                     "}} }}\n}}\ninstance {{ model = well }}\n",
                     vec3({-1, 0.3, -1}, size), vec3({-1, 0.3, 1}, size), vec3({1, 0.3, 1}, size),
                     vec3({1, 0.3, -1}, size), vec3({1, 0.3 + wall_height, 1}, size),
                     vec3({1, 0.3 + wall_height, -1}, size));
}

/// A slanting triangle, twice in the same place, that fills the picture and is lit from the side of the eye.
std::string twins(double size) {
  const std::string one = fmt::format("triangle {{ vertices = [{}, {}, {}]  color = white }}\n",
                                      vec3({-6, -4, 3}, size), vec3({0.2, 9, 9}, size), vec3({7, -5, 5}, size));
  return "viewport_size = 1 x 1\nprojection_plane_d = 1\nbackground = black\n" + one + one +
         "light { type = directional  intensity = 1  direction = (0.3, 0.7, -1.1) }\n";
}

bool shaded_in_well(int column, int side) { return across_floor(column, side) > 1 - light_across * wall_height; }
bool never_shaded(int, int) { return false; }

struct Body {
  const char* name;
  std::string (*scene)(double size);
  bool (*shaded)(int column, int side);
};
constexpr std::array bodies{Body{"hollow solid", solid_well, shaded_in_well},
                            Body{"hollow mesh", mesh_well, shaded_in_well},
                            Body{"coincident twins", twins, never_shaded}};

struct Guard {
  const char* name;
  SelfHit guard;
};
constexpr std::array guards{Guard{"exclusion", SelfHit::exclusion}, Guard{"epsilon 0.001", SelfHit::epsilon},
                            Guard{"bump 0.001", SelfHit::normal_bump}};

Settings with_guard(SelfHit guard) {
  Settings settings;
  settings.self_hit = guard;
  settings.shadow_epsilon = 1e-3;
  settings.near = 0;
  return settings;
}

/// Percent of the pixels whose shadow is not that of the closed form.
double wrong_shadows(const Body& body, double size, SelfHit guard, const StabilityRun& run) {
  constexpr int side = 64;
  const Scene scene = parse_scene(body.scene(size), "leaving", ".");
  const Frame frame = picture_of(scene, {scene.camera, side, side}, with_guard(guard), Channel::shadow, run);
  int wrong = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) wrong += (frame.shadow.at(x, y) != 0) != body.shaded(x, side) ? 1 : 0;
  return percent(wrong, side * side);
}

void measure(const StabilityRun& run, Rows& rows) {
  for (const double size : {1e-4, 1e-3, 1e-2, 1.0, 1e2, 1e4, 1e6})
    for (const Body& body : bodies) {
      const double robust = wrong_shadows(body, size, SelfHit::offset, run);
      for (const Guard& naive : guards)
        rows.add(size, fmt::format("{}, {}", body.name, naive.name), wrong_shadows(body, size, naive.guard, run),
                 robust, "% of pixels");
    }
}

StabilityPicture picture(double size) {
  return {.scene = solid_well(size), .naive = with_guard(SelfHit::exclusion), .robust = with_guard(SelfHit::offset)};
}

}  // namespace

extern const StabilityExperiment guards_at_a_surface{
    .key = "guards-at-a-surface",
    .place = {Subject::rays, 85},
    .title = "What each guard against self-hits misses",
    .keywords = "exclusion, self-hit, self-intersection, epsilon, bias, bump, offset, CSG, concave, coincident, acne",
    .knob = "size of the scene, in world units",
    .naive = "exclusion, an epsilon or a bump of 0.001",
    .robust = "offset by the bound of the point's own error",
    .explanation =
        "Exclusion needs no length, but loses every shadow of a solid in its own hollow, and still meets the twin of a "
        "triangle and, on their edge, its neighbour. An epsilon and a bump lose walls that are nearer than they are "
        "long, and far out, where floats are spaced more widely, they do not guard.",
    .safe = "Exclusion: convex bodies and single triangles. An epsilon or a bump of 0.001: scenes of 1 to 100 units.",
    .window = nowhere_safe,
    .series = {{.names = "hollow solid, exclusion|*", .title = "pixels with a wrong shadow", .unit = "%"}},
    .add_rows = measure,
    .picture = picture,
    .frames = {1.0}};

}  // namespace ps::stability::guards_at_a_surface
