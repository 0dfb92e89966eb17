#include "study/model/views.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/check.h"
#include "document/number_list.h"
#include "math/portable.h"
#include "options/scene_settings.h"
#include "render/render.h"

namespace ps {
namespace {

/// The middle one of all visible depths; the projection plane's where no surface is seen.
double middle_depth(const Scene& scene, const View& view, StudyControl& control) {
  constexpr int side = 64;
  RenderRequest how;
  how.channels = Channel::depth;
  Prepared prepared;
  const Frame frame = render(scene, {view.camera, side, side}, settings_for(scene), how, prepared, control.progress());
  std::vector<float> depths;
  for (const float depth : frame.depth.pixels())
    if (std::isfinite(depth)) depths.push_back(depth);
  if (depths.empty()) return view.camera.projection_plane_d;
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::nth_element(depths.begin(), middle, depths.end());
  return static_cast<double>(*middle);
}

}  // namespace

std::vector<View> orbit_views(const Scene& scene, const View& view, int count, StudyControl& control) {
  std::vector<View> views{view};
  if (count < 2) return views;
  const Camera& camera = view.camera;
  const double distance = middle_depth(scene, view, control) / std::sqrt(dot(camera.forward, camera.forward));
  const Vec3d centre = camera.position + camera.forward * distance;
  for (int i = 1; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    const double c = portable::cos(angle), s = portable::sin(angle);
    View next = view;
    next.camera.right = camera.right * c + camera.forward * s;
    next.camera.forward = camera.forward * c - camera.right * s;
    next.camera.position = centre - next.camera.forward * distance;
    views.push_back(next);
  }
  return views;
}

std::vector<View> parse_views(std::string_view text, std::string_view name, const View& view) {
  std::vector<View> views;
  int number = 0;
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (line.empty() || line.front() == '#') continue;
    try {
      views.push_back({parse_camera_text(line), view.width, view.height});
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}:{}: {}", name, number, error.what()));
    }
  }
  if (views.empty()) throw InputError(fmt::format("{}: found no view, expected a camera on each line", name));
  return views;
}

}  // namespace ps
