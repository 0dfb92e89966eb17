#include "inspect/space_projection.h"

#include <algorithm>
#include <cmath>

#include "frame/viewport.h"

namespace ps {
namespace {

constexpr double touching = 0.012;  // of the depth: rays begin and end on surfaces, and spheres are drawn as facets
constexpr double probe_step = 3;    // pixels between two looks at the depth picture
constexpr int most_probes = 2000;

/// Depth along a line on the picture: its inverse is what is linear there.
SpacePlace between(const SpacePlace& a, const SpacePlace& b, double t) {
  return {a.at + (b.at - a.at) * t, 1 / (1 / a.z + (1 / b.z - 1 / a.z) * t)};
}

}  // namespace

SpaceProjection::SpaceProjection(const View& view, const Settings& settings, double near)
    : space_(raster::make_camera_space(view.camera)),
      projection_(raster::make_canvas_projection<double>(make_viewport<double>(view, settings))), near_(near) {}

std::optional<SpacePlace> SpaceProjection::point(const Vec3d& world) const {
  const Vec3d camera = camera_point(world);
  if (!(camera.z >= near_)) return {};
  return place(camera);
}

std::optional<SpaceRun> SpaceProjection::line(const Vec3d& from, const Vec3d& to) const {
  Vec3d a = camera_point(from), b = camera_point(to);
  if (!(a.z >= near_) && !(b.z >= near_)) return {};
  if (a.z < near_) a += (b - a) * ((near_ - a.z) / (b.z - a.z));
  if (b.z < near_) b += (a - b) * ((near_ - b.z) / (a.z - b.z));
  return SpaceRun{place(a), place(b), false};
}

std::vector<SpacePlace> SpaceProjection::polygon(const std::vector<Vec3d>& corners) const {
  std::vector<SpacePlace> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d a = camera_point(corners[i]), b = camera_point(corners[(i + 1) % corners.size()]);
    if (a.z >= near_) kept.push_back(place(a));
    if ((a.z < near_) != (b.z < near_)) kept.push_back(place(a + (b - a) * ((near_ - a.z) / (b.z - a.z))));
  }
  return kept;
}

bool is_hidden(const Image<float>& depth, const SpacePlace& place) {
  const double x = std::floor(place.at.x), y = std::floor(place.at.y);
  if (!(x >= 0 && y >= 0 && x < depth.width() && y < depth.height())) return false;
  return place.z * (1 - touching) > static_cast<double>(depth.at(static_cast<int>(x), static_cast<int>(y)));
}

std::vector<SpaceRun> visible_runs(const Image<float>& depth, const SpaceRun& line) {
  const Vec2d across = line.to.at - line.from.at;
  const double length = std::hypot(across.x, across.y);
  if (!std::isfinite(length)) return {};
  const int probes = std::clamp(static_cast<int>(std::ceil(length / probe_step)), 1, most_probes);
  std::vector<SpaceRun> runs;
  for (int i = 0; i < probes; ++i) {
    const SpacePlace from = between(line.from, line.to, static_cast<double>(i) / probes);
    const SpacePlace to = between(line.from, line.to, static_cast<double>(i + 1) / probes);
    const bool hidden = is_hidden(depth, between(line.from, line.to, (i + 0.5) / probes));
    if (!runs.empty() && runs.back().hidden == hidden)
      runs.back().to = to;
    else
      runs.push_back({from, to, hidden});
  }
  return runs;
}

}  // namespace ps
