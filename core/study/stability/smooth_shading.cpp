#include <array>

#include "scene/generate/uv_sphere.h"
#include "study/stability/shaded_ball.h"

namespace ps::stability {
namespace {

Vec3d unit(const Vec3d& v) { return v / std::sqrt(dot(v, v)); }

double longest_side(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return std::sqrt(std::max({dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)}));
}

struct Peaks {
  double mean = 0;
  double least = 0;  ///< of 20 lights, on average
};

/// The brightest highlight that a light leaves on a ball seen from far away, over many lights. Truth: 1.
enum class Where { corners, pixels };
Peaks peaks(const Mesh& mesh, double exponent, Where where, const StabilityRun& run) {
  run.check();
  Random random(run.seed);
  const Vec3d to_eye(0, 0, -1);
  // What corners keep of a peak scatters by as much as its mean; what pixels keep hardly at all.
  constexpr int lights_at_a_time = 20;  // the more lights, the smaller the least of them
  const int lights = lights_at_a_time * (where == Where::corners ? run.count(30, 3) : 3);
  Peaks result;
  double least = 1;
  for (int i = 0; i < lights; ++i) {
    Vec3d to_light = random.direction();
    while (dot(to_light, to_eye) < 0.2) to_light = random.direction();
    double peak = 0;
    if (where == Where::corners) {
      for (const Vec3d& normal : mesh.normals)
        if (dot(normal, to_eye) > 0) peak = std::max(peak, highlight(normal, to_light, to_eye, exponent));
    } else {
      // In every triangle around the highlight, interpolated and brought back to length 1, in steps of a pixel of a
      // picture in which the ball is 200 wide.
      const Vec3d half = unit(to_light + to_eye);
      const double around = mesh.triangles.size() > 5000 ? 0.99 : 0.5;
      for (const MeshTriangle& t : mesh.triangles) {
        const Vec3d &a = mesh.normals[static_cast<std::size_t>(t.normal[0])],
                    &b = mesh.normals[static_cast<std::size_t>(t.normal[1])],
                    &c = mesh.normals[static_cast<std::size_t>(t.normal[2])];
        if (std::min({dot(a, half), dot(b, half), dot(c, half)}) < around) continue;
        const int steps = static_cast<int>(std::ceil(100 * longest_side(a, b, c)));
        for (int u = 0; u <= steps; ++u)
          for (int v = 0; v + u <= steps; ++v)
            peak = std::max(peak, highlight(unit(a * double(u) + b * double(v) + c * double(steps - u - v)), to_light,
                                            to_eye, exponent));
      }
    }
    result.mean += peak / lights;
    least = std::min(least, peak);
    if ((i + 1) % lights_at_a_time != 0) continue;
    result.least += least * lights_at_a_time / lights;
    least = 1;
  }
  return result;
}

struct Cut {
  int slices, stacks;
  double triangles() const { return 2.0 * slices * (stacks - 1); }
};

std::vector<StabilityRow> measure_gouraud(const StabilityRun& run) {
  Rows rows(run);
  for (const Cut& cut : {Cut{8, 4}, Cut{20, 10}, Cut{32, 16}, Cut{64, 32}, Cut{128, 64}, Cut{256, 128}}) {
    const Mesh mesh = make_uv_sphere({cut.slices, cut.stacks});
    for (const double exponent : {50.0, 500.0}) {
      const Peaks naive = peaks(mesh, exponent, Where::corners, run);
      const Peaks robust = peaks(mesh, exponent, Where::pixels, run);
      const std::string name = exponent < 100 ? "exponent 50" : "exponent 500";
      rows.push_back({cut.triangles(), name + ", mean", naive.mean, robust.mean, "of the peak is kept"});
      rows.push_back({cut.triangles(), name + ", least", naive.least, robust.least, "of the peak is kept"});
    }
    const ShadedBallErrors errors = shaded_ball_errors(mesh, 50, run);
    rows.push_back({cut.triangles(), "error, exponent 50", errors.corners, errors.pixels, "RMSE, levels"});
    rows.push_back({cut.triangles(), "error, one light for a facet", errors.facets, errors.pixels, "RMSE, levels"});
  }
  return rows;
}

std::vector<StabilityRow> measure_unnormalised(const StabilityRun& run) {
  Rows rows(run);
  for (const double degrees : {0.0, 5.0, 10.0, 20.0, 30.0, 60.0, 90.0}) {
    const double angle = degrees * pi / 180;
    const Vec3d a(0, 0, 1), b(std::sin(angle), 0, std::cos(angle)), middle = (a + b) * 0.5;
    const double length = std::sqrt(dot(middle, middle));
    rows.push_back(
        {degrees, "half-way between two corners", length, std::sqrt(dot(unit(middle), unit(middle))), "length"});
    rows.push_back({degrees, "highlight of exponent 50", std::pow(length, 50), 1, "of the peak is kept"});
  }
  return rows;
}

/// Points that their interpolated normal calls lit, but that lie on a facet turned away from the light, whose shadow
/// ray therefore starts into the body. With the offset of Hanika the point is moved onto the smooth surface first; on a
/// convex body that puts it outside every facet.
std::vector<StabilityRow> measure_terminator(const StabilityRun& run) {
  Rows rows(run);
  for (const Cut& cut : {Cut{12, 6}, Cut{20, 10}, Cut{64, 32}, Cut{256, 128}}) {
    run.check();
    const Mesh mesh = make_uv_sphere({cut.slices, cut.stacks});
    std::vector<double> areas;
    double total = 0;
    for (const MeshTriangle& t : mesh.triangles) {
      const Vec3d n = cross(mesh.positions[t.position[1]] - mesh.positions[t.position[0]],
                            mesh.positions[t.position[2]] - mesh.positions[t.position[0]]);
      areas.push_back(total += std::sqrt(dot(n, n)));
    }
    Random random(run.seed);
    double lit = 0, dark = 0, still_dark = 0;
    const int points = run.count(200000, 20000);
    for (int i = 0; i < points; ++i) {
      const auto which =
          static_cast<std::size_t>(std::lower_bound(areas.begin(), areas.end(), random.unit() * total) - areas.begin());
      const MeshTriangle& t = mesh.triangles[std::min(which, areas.size() - 1)];
      std::array<Vec3d, 3> p, n;
      for (std::size_t k = 0; k < 3; ++k) {
        p[k] = mesh.positions[t.position[k]];
        n[k] = mesh.normals[static_cast<std::size_t>(t.normal[k])];
      }
      double u = random.unit(), v = random.unit();
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const std::array w{1 - u - v, u, v};
      const Vec3d point = p[0] * w[0] + p[1] * w[1] + p[2] * w[2];
      const Vec3d to_light = random.direction();
      if (!(dot(n[0] * w[0] + n[1] * w[1] + n[2] * w[2], to_light) > 0)) continue;
      ++lit;
      Vec3d facet = cross(p[1] - p[0], p[2] - p[0]);
      if (dot(facet, point) < 0) facet = -facet;
      const bool away = dot(facet, to_light) <= 0;
      dark += away ? 1 : 0;
      if (!away) continue;
      Vec3d moved(0);  // onto the planes through the corners, mixed
      for (std::size_t k = 0; k < 3; ++k) moved += (point - n[k] * std::min(0.0, dot(point - p[k], n[k]))) * w[k];
      // The body lies inside the unit ball: a ray that does not come nearer to its middle than the facets misses it.
      const double inside = std::cos(pi / cut.slices) * std::cos(pi / (2 * cut.stacks));
      const double along = -dot(moved, to_light);
      const Vec3d closest = moved + to_light * std::max(0.0, along);
      still_dark += dot(closest, closest) < inside * inside ? 1 : 0;
    }
    rows.push_back({cut.triangles(), "ball with smooth normals", percent(dark, lit), percent(still_dark, lit),
                    "% of smooth-lit points dark"});
  }
  return rows;
}

std::vector<StabilityRow> measure_silhouette(const StabilityRun& run) {
  Rows rows(run);
  for (const double radius : {10.0, 50.0, 100.0, 200.0, 500.0, 1000.0}) {
    const auto deviation = [&](int segments) {  // measured along one chord
      double worst = 0;
      const double angle = 2 * pi / segments;
      const Vec2d a(radius, 0), b(radius * std::cos(angle), radius * std::sin(angle));
      for (int i = 0; i <= 1000; ++i) {
        const Vec2d p = a + (b - a) * (i / 1000.0);
        worst = std::max(worst, radius - std::hypot(p.x, p.y));
      }
      return worst;
    };
    const int enough = static_cast<int>(std::ceil(pi / std::acos(1 - 0.5 / radius)));
    for (const int segments : {10, 20, 45, 100})
      rows.push_back({static_cast<double>(segments), "radius " + std::to_string(static_cast<int>(radius)) + " px",
                      deviation(segments), deviation(enough), "px off the circle"});
    rows.push_back({static_cast<double>(enough),
                    "enough for radius " + std::to_string(static_cast<int>(radius)) + " px", deviation(enough),
                    deviation(enough), "px off the circle"});
  }
  return rows;
}

StabilityPicture picture_gouraud(double) {
  StabilityPicture picture{.scene = "cgfs/shading"};
  picture.robust.renderer = Renderer::rasterizer;
  picture.naive = picture.robust;
  picture.naive.shading = Shading::gouraud;
  return picture;
}
StabilityPicture picture_unnormalised(double) {
  StabilityPicture picture = picture_gouraud(0);
  picture.naive = picture.robust;
  picture.naive.renormalise = false;
  return picture;
}
StabilityPicture picture_silhouette(double) {
  StabilityPicture picture{.scene = "cgfs/spheres"};
  picture.robust.renderer = Renderer::rasterizer;
  picture.naive = picture.robust;
  picture.naive.tessellation = 10;
  return picture;
}

constexpr std::array triangles{450.0};
constexpr std::array angles{30.0};
constexpr std::array segments{10.0};

}  // namespace

const StabilityExperiment gouraud_highlight{
    .key = "gouraud-highlight",
    .title = "Gouraud loses highlights",
    .knob = "triangles of the ball",
    .naive = "light at the corners",
    .robust = "light at every pixel",
    .explanation =
        "Between corners light only mixes, so nothing is ever brighter than the brightest corner. A highlight "
        "that falls between corners is gone, and flashes up when it meets one.",
    .safe = "Triangles smaller than the highlight: 65,000 for exponent 50.",
    .window = {65000, everywhere},
    .measure = measure_gouraud,
    .picture = picture_gouraud,
    .frames = triangles};

const StabilityExperiment unnormalised_interpolated_normals{
    .key = "unnormalised-interpolated-normals",
    .title = "Interpolated normals get short",
    .knob = "angle between the corners' normals (degrees)",
    .naive = "as interpolated",
    .robust = "brought back to length 1",
    .explanation = "The middle of two unit vectors lies on their chord, inside the circle. A highlight raises the "
                   "missing length to its exponent: 3 % too short is 82 % too dark at exponent 50.",
    .safe = "Up to 5 degrees.",
    .window = {0, 5},
    .measure = measure_unnormalised,
    .picture = picture_unnormalised,
    .frames = angles};

const StabilityExperiment shadow_terminator{
    .key = "shadow-terminator",
    .title = "The shadow terminator",
    .knob = "triangles of the ball",
    .naive = "shadow ray from the facet",
    .robust = "from the smooth surface (Hanika)",
    .explanation = "Smooth normals call points lit whose facet is turned away, and their shadow rays meet the facet "
                   "next door. The share of such points falls with the angle between neighbours.",
    .safe = "Fine meshes: a quarter of a percent at 65,000 triangles.",
    .window = {65000, everywhere},
    .measure = measure_terminator};

const StabilityExperiment silhouette_tessellation{
    .key = "silhouette-tessellation",
    .title = "Corners on round outlines",
    .knob = "segments of a circle",
    .naive = "so many segments at any size",
    .robust = "pi / acos(1 - 0.5 / radius) segments",
    .explanation = "A chord leaves its circle by R (1 - cos(pi / n)), which grows with the radius on the screen. How "
                   "many segments are enough follows from the size and from half a pixel of error.",
    .safe = "100 segments up to a radius of 1,000 pixels.",
    .window = {100, everywhere},
    .measure = measure_silhouette,
    .picture = picture_silhouette,
    .frames = segments};

}  // namespace ps::stability
