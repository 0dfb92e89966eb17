#include "inspect/space_picture.h"

#include <cmath>
#include <vector>

#include "frame/display_frame.h"
#include "options/renderer_kind.h"

namespace ps {
namespace {

/// What a scene without lights is seen by from outside, so that balls are round: a light beside the viewer.
std::vector<Light> own_lights(const Camera& camera) {
  Light ambient, directional;
  ambient.intensity = 0.4;
  directional.kind = LightKind::directional;
  directional.intensity = 0.6;
  directional.direction = camera.up * 0.6 - camera.right * 0.4 - camera.forward;
  return {ambient, directional};
}

}  // namespace

SpacePicture draw_space_picture(const Scene& scene, const View& view, double near, Prepared& prepared,
                                Progress& progress) {
  Settings settings;
  settings.renderer = renderer_for(PictureWay::fragments);
  settings.near = near / view.camera.projection_plane_d;
  settings.backface_culling = false;  // open models are seen from all sides
  Scene drawn = scene;
  drawn.canvas_items = {};  // they lie on the picture, not in space
  if (scene.lights->empty()) drawn.lights.edit([&](std::vector<Light>& lights) { lights = own_lights(view.camera); });
  RenderRequest wanted;
  wanted.channels = Channel::depth | Channel::ids;
  if (scene_traits(drawn).csg) {  // has no triangles
    settings.renderer = renderer_for(PictureWay::rays);
    settings.reflection_depth = 0;
    settings.shadows = Shadows::none;
  }
  const Frame frame = render(drawn, view, settings, wanted, prepared, progress);
  return {view, near, display_frame(frame, settings), frame.depth, frame.ids};
}

Image<Rgb8> paled(const SpacePicture& picture, const std::vector<bool>& ground, Rgb8 paper) {
  constexpr double strength = 0.6, ground_strength = 0.2;
  Image<Rgb8> out = picture.levels;
  for (std::size_t i = 0; i < out.pixels().size(); ++i) {
    Rgb8& p = out.pixels()[i];
    const auto object = static_cast<std::size_t>(picture.ids.pixels()[i].object);
    const bool is_ground = object < ground.size() && ground[object];
    const double keep = std::isinf(picture.depth.pixels()[i]) ? 0 : is_ground ? ground_strength : strength;
    const auto mix = [&](std::uint8_t level, std::uint8_t other) {
      return static_cast<std::uint8_t>(std::lround(level * keep + other * (1 - keep)));
    };
    p = {mix(p.r, paper.r), mix(p.g, paper.g), mix(p.b, paper.b)};
  }
  return out;
}

}  // namespace ps
