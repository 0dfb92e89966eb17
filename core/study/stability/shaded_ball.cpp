#include "study/stability/shaded_ball.h"

#include <array>

namespace ps::stability {
namespace {

Vec3d unit(const Vec3d& v) { return v / std::sqrt(dot(v, v)); }

const Vec3d to_eye(0, 0, -1);

/// What a light gives at most, and how far to the side the surface may be seen (cosine): at the outline a pixel's width
/// spans any number of normals.
constexpr double diffuse = 0.6, specular = 0.5, rim = 0.3;

/// A pixel of the ball: the smooth normal there, and the triangle with the corners' shares.
struct BallPixel {
  Vec3d normal{0}, shares{0};
  std::size_t triangle = 0;
};

std::array<Vec3d, 3> corners_of(const Mesh& ball, const MeshTriangle& t) {
  return {ball.positions[t.position[0]], ball.positions[t.position[1]], ball.positions[t.position[2]]};
}

/// Pixels of a picture of side x side that show a triangle, without the ball's rim.
std::vector<BallPixel> pixels_of(const Mesh& ball, int side) {
  std::vector<BallPixel> pixels;
  const double step = 2.0 / side;
  const auto first = [&](double low) { return std::max(0, static_cast<int>(std::floor((low + 1) / step - 0.5))); };
  const auto last = [&](double high) { return std::min(side - 1, static_cast<int>(std::ceil((high + 1) / step))); };
  for (std::size_t i = 0; i < ball.triangles.size(); ++i) {
    const auto p = corners_of(ball, ball.triangles[i]);
    if (p[0].z + p[1].z + p[2].z > 0) continue;  // on the far side
    const double twice = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
    if (std::abs(twice) < 1e-14) continue;
    const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [low, high] = std::minmax({p[0].y, p[1].y, p[2].y});
    for (int row = first(low); row <= last(high); ++row)
      for (int column = first(left); column <= last(right); ++column) {
        const double x = (column + 0.5) * step - 1, y = (row + 0.5) * step - 1;
        const auto share = [&](const Vec3d& a, const Vec3d& b) {
          return ((a.x - x) * (b.y - y) - (a.y - y) * (b.x - x)) / twice;
        };
        const Vec3d shares(share(p[1], p[2]), share(p[2], p[0]), share(p[0], p[1]));
        if (!(shares.x >= 0 && shares.y >= 0 && shares.z >= 0)) continue;
        const Vec3d normal(x, y, -std::sqrt(std::max(0.0, 1 - x * x - y * y)));
        if (dot(normal, to_eye) < rim) continue;
        pixels.push_back({normal, shares, i});
      }
  }
  return pixels;
}

}  // namespace

double highlight(const Vec3d& normal, const Vec3d& to_light, const Vec3d& towards, double exponent) {
  const Vec3d mirrored = normal * (2 * dot(normal, to_light)) - to_light;
  const double cosine = dot(unit(mirrored), towards);
  return cosine > 0 && dot(normal, to_light) > 0 ? std::pow(cosine, exponent) : 0;
}

ShadedBallErrors shaded_ball_errors(const Mesh& ball, double exponent, const StabilityRun& run) {
  constexpr int lights = 20;
  const std::vector<BallPixel> pixels = pixels_of(ball, run.side(200));
  Random random(run.seed);
  std::vector<double> at_corner(ball.positions.size()), at_facet(ball.triangles.size());
  ShadedBallErrors sum;
  for (int i = 0; i < lights; ++i) {
    run.check();
    Vec3d to_light = random.direction();
    while (dot(to_light, to_eye) < 0.2) to_light = random.direction();
    const auto light_at = [&](const Vec3d& normal) {
      return 255 * std::min(1.0, diffuse * std::max(0.0, dot(normal, to_light)) +
                                     specular * highlight(normal, to_light, to_eye, exponent));
    };
    for (std::size_t k = 0; k < at_corner.size(); ++k) at_corner[k] = light_at(ball.positions[k]);
    for (std::size_t k = 0; k < at_facet.size(); ++k) {
      const auto p = corners_of(ball, ball.triangles[k]);
      const Vec3d facet = unit(cross(p[1] - p[0], p[2] - p[0]));
      at_facet[k] = light_at(dot(facet, p[0]) < 0 ? -facet : facet);
    }
    for (const BallPixel& pixel : pixels) {
      const MeshTriangle& t = ball.triangles[pixel.triangle];
      const auto p = corners_of(ball, t);
      const double truth = light_at(pixel.normal);
      const auto add = [&](double& to, double light) { to += (light - truth) * (light - truth); };
      add(sum.corners, at_corner[t.position[0]] * pixel.shares.x + at_corner[t.position[1]] * pixel.shares.y +
                           at_corner[t.position[2]] * pixel.shares.z);
      add(sum.pixels, light_at(unit(p[0] * pixel.shares.x + p[1] * pixel.shares.y + p[2] * pixel.shares.z)));
      add(sum.facets, at_facet[pixel.triangle]);
    }
  }
  const double all = static_cast<double>(lights) * static_cast<double>(pixels.size());
  return {std::sqrt(sum.corners / all), std::sqrt(sum.pixels / all), std::sqrt(sum.facets / all)};
}

}  // namespace ps::stability
