#include "study/stability/shadow_floor.h"

#include <fmt/format.h>

namespace ps::stability {

std::string roof_text(double camera_z) {
  return fmt::format("viewport_size = 1.5 x 1\nprojection_plane_d = 1\nbackground = (190, 215, 240)\n"
                     "camera {{ position = (0, 0, {}) }}\n"
                     "rectangle {{ name = floor corner = (-30, -1, -20) side_a = (60, 0, 0) side_b = (0, 0, 80)\n"
                     "            color = (230, 225, 210) }}\n"
                     "box {{ name = roof center = (0, 3, 0) size = (4, 0.2, 4) color = (150, 110, 80) }}\n"
                     "light {{ type = ambient intensity = 0.25 }}\n"
                     "light {{ type = directional intensity = 0.75 direction = (0, 1, 0) }}\n",
                     camera_z);
}

Settings shadow_settings(Renderer renderer, Shadows shadows, double near) {
  Settings settings;
  settings.renderer = renderer;
  settings.shadows = shadows;
  settings.near = near;
  settings.precision = sends_rays(renderer) ? Precision::float64 : Precision::float32;
  return settings;
}

double wrong_floor_share(const Scene& scene, const Settings& fragments, const StabilityRun& run) {
  constexpr int floor_object = 0, sun = 1;
  const View view{scene.camera, 150, 100};
  const Channel channels = Channel::ids | Channel::shadow;
  const Settings rays = shadow_settings(renderer_for(PictureWay::rays), Shadows::traced, fragments.near);
  const Frame truth = picture_of(scene, view, rays, channels, run);
  const Frame frame = picture_of(scene, view, fragments, channels, run);
  const auto bit = [](const Frame& f, int x, int y) { return f.shadow.at(x, y) >> sun & 1; };
  double all = 0, wrong = 0;
  for (int y = 1; y + 1 < view.height; ++y)
    for (int x = 1; x + 1 < view.width; ++x) {
      bool plain = frame.ids.at(x, y).object == floor_object;
      for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}})
        plain = plain && truth.ids.at(x + dx, y + dy).object == floor_object &&
                bit(truth, x + dx, y + dy) == bit(truth, x, y);
      if (!plain) continue;
      ++all;
      wrong += bit(truth, x, y) != bit(frame, x, y) ? 1 : 0;
    }
  return percent(wrong, all);
}

}  // namespace ps::stability
