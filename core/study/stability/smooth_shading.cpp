#include <fmt/format.h>

#include "math/unit.h"
#include "scene/generate/uv_sphere.h"
#include "study/stability/shaded_ball.h"

namespace ps::stability::smooth_shading {
namespace {

void measure_gouraud(const StabilityRun& run, Rows& rows) {
  const Settings gouraud{.shading = Shading::gouraud}, phong{}, flat{.shading = Shading::flat};
  const BallErrors errors(50, run);
  for (const BallCut& cut :
       {BallCut{8, 4}, BallCut{20, 10}, BallCut{32, 16}, BallCut{64, 32}, BallCut{128, 64}, BallCut{256, 128}}) {
    const Mesh mesh = make_uv_sphere({cut.slices, cut.stacks});
    // What coarse balls keep of a peak differs from light to light by as much as its mean.
    const int lights = 20 * (cut.slices <= 32 ? run.count(5, 2) : 1);
    for (const int exponent : {50, 500}) {
      const KeptPeaks naive = kept_peaks(mesh, exponent, gouraud, lights, run);
      const KeptPeaks robust = kept_peaks(mesh, exponent, phong, 20, run);
      const std::string name = fmt::format("exponent {}", exponent);
      rows.add(cut.triangles(), name + ", mean", naive.mean, robust.mean, "of the peak is kept");
      rows.add(cut.triangles(), name + ", least", naive.least, robust.least, "of the peak is kept");
    }
    const double robust = errors.rmse(mesh, phong);
    rows.add(cut.triangles(), "error, exponent 50", errors.rmse(mesh, gouraud), robust, "RMSE, levels");
    rows.add(cut.triangles(), "error, one light for a facet", errors.rmse(mesh, flat), robust, "RMSE, levels");
  }
}

void measure_unnormalised(const StabilityRun& run, Rows& rows) {
  for (const int degrees : {5, 10, 20, 30, 60, 90}) {
    const Mesh mesh = make_uv_sphere({360 / degrees, 180 / degrees});
    for (const int exponent : {50, 500}) {
      const NormalErrors errors = normal_errors(mesh, exponent, run);
      rows.add(degrees, fmt::format("ball, exponent {}", exponent), errors.as_interpolated, errors.renormalised,
               "levels of 255 (largest)");
    }
  }
  for (const double degrees : {0.0, 5.0, 10.0, 20.0, 30.0, 60.0, 90.0}) {
    const double angle = degrees * pi / 180;
    const Vec3d a(0, 0, 1), b(std::sin(angle), 0, std::cos(angle)), middle = (a + b) * 0.5,
                                                                    brought_back = unit_of(middle);
    const double length = std::sqrt(dot(middle, middle));
    rows.add(degrees, "half-way between two vertices", length, std::sqrt(dot(brought_back, brought_back)), "length");
    // As fixed-function hardware took it. The program divides by both lengths, so its highlights only lose their shape.
    rows.add(degrees, "(N.H)^50 without division by lengths", std::pow(dot(middle, brought_back), 50),
             std::pow(dot(brought_back, brought_back), 50), "of the peak is kept");
  }
}

/// The book's model of a sphere, of rings of as many quadrilaterals each.
StabilityPicture ball_of_rings(int rings) {
  StabilityPicture picture{.scene = fmt::format(R"(
viewport_size = 1 x 1
projection_plane_d = 1
background = black
model {{ name = ball  sphere_divisions = {}  color = (90, 150, 230)  specular = 50 }}
instance {{ model = ball  transform {{ rotation = <25 degrees around the X axis>  translation = (0, 0, 2.3) }} }}
light {{ type = ambient  intensity = 0.2 }}
light {{ type = directional  intensity = 0.8  direction = (1, 1, -1) }}
)",
                                                rings)};
  picture.robust.renderer = renderer_for(PictureWay::fragments);
  picture.naive = picture.robust;
  return picture;
}
StabilityPicture picture_gouraud(double triangles) {
  StabilityPicture picture = ball_of_rings(static_cast<int>(std::lround(std::sqrt(triangles / 2))));
  picture.naive.shading = Shading::gouraud;
  return picture;
}
StabilityPicture picture_unnormalised(double degrees) {
  StabilityPicture picture = ball_of_rings(static_cast<int>(std::lround(360 / degrees)));
  picture.naive.renormalise = false;
  return picture;
}

}  // namespace

extern const StabilityExperiment gouraud_highlight{
    .key = "gouraud-highlight",
    .place = {Subject::shading, 10},
    .title = "Gouraud shading loses highlights",
    .keywords = "Gouraud, per vertex, specular, Phong, highlight",
    .knob = "triangles of the ball",
    .naive = "lighting at the vertices (Gouraud)",
    .robust = "lighting at each pixel (Phong)",
    .explanation =
        "Gouraud shading evaluates the lighting at the vertices and interpolates the colours, so no pixel is brighter "
        "than the brightest vertex. A highlight between vertices is lost, and flashes when it meets one.",
    .safe = "Triangles much smaller than the highlight: 65,000 keep 98 % of a peak of exponent 50.",
    .window = {65000, everywhere},
    .series = {{.names = "exponent 50, mean|*mean",
                .title = "part of the highlight's peak that is kept, mean",
                .unit = "of 1",
                .better = Better::higher},
               {.names = "*least",
                .title = "part of the highlight's peak that is kept, least",
                .unit = "of 1",
                .better = Better::higher},
               {.names = "error, *", .title = "error of the ball (RMSE)", .unit = "levels of 255"}},
    .add_rows = measure_gouraud,
    .picture = picture_gouraud,
    .frames = {128.0, 512.0, 2048.0, 8192.0, 32768.0}};

extern const StabilityExperiment unnormalised_interpolated_normals{
    .key = "unnormalised-interpolated-normals",
    .place = {Subject::shading, 20},
    .set_up = SetUp::reproduction,
    .title = "Unnormalised normals: interpolated normals get short",
    .keywords = "normalize, renormalise, Phong, highlight, interpolation",
    .knob = "angle between neighbouring vertex normals (degrees)",
    .naive = "as interpolated",
    .robust = "renormalised",
    .explanation =
        "The mean of two unit vectors lies on their chord and is shorter than 1. The mirrored direction 2 N (N.L) - L "
        "then points elsewhere, so highlights move and lose their shape. Formulas that do not divide by the length "
        "lose 82 % of a peak of exponent 50 at 30 degrees.",
    .safe = "Up to 5 degrees: at most 6 of 255 levels.",
    .window = {0, 5},
    .series =
        {{.names = "ball*", .title = "largest error of the ball", .unit = "levels of 255"},
         {.names = "half-way*", .title = "length of the interpolated normal", .unit = "of 1", .better = Better::higher},
         {.names = "(N.H)*",
          .title = "part of the highlight's peak that is kept",
          .unit = "of 1",
          .better = Better::higher}},
    .add_rows = measure_unnormalised,
    .picture = picture_unnormalised,
    .frames = {90.0, 60.0, 30.0, 20.0, 10.0}};

}  // namespace ps::stability::smooth_shading
