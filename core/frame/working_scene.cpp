#include "frame/working_scene.h"

#include "options/renderer_kind.h"

namespace ps {
namespace {

/// A part of a scene as Prepared keeps it.
template <class T>
struct KeptPart {
  Part<T> part;
  std::size_t bytes = 0;
  std::size_t heap_bytes() const { return bytes; }
};

/// Graphics drivers do whatever `precision` says.
bool computes_in_float(const Settings& settings) {
  return settings.precision == Precision::float32 || renderer_kind(settings.renderer).added;
}

WorkingSpace space_for(const Scene& scene, const Settings& settings, Prepared& prepared) {
  if (!settings.camera_relative || runs_listing(settings.renderer)) return {};
  const Vec3d& eye = scene.camera.position;
  const Key key = Key("working space").add(scene.geometry.revision()).add(eye.x).add(eye.y).add(eye.z);
  WorkingSpace space = *prepared.get<WorkingSpace>(key, [&] { return working_space(scene); });
  if (!computes_in_float(settings)) space.origin = {0, 0, 0};  // double has digits enough
  return space;
}

Key key_in(const char* product, std::uint64_t revision, const WorkingSpace& space) {
  const Vec3d& o = space.origin;
  return Key(product).add(revision).add(o.x).add(o.y).add(o.z).add(space.scale);
}

Scene scene_in(const Scene& scene, const WorkingSpace& space, Illumination illumination, Prepared& prepared) {
  Scene result = scene;
  result.camera = moved(scene.camera, space);
  using KeptGeometry = KeptPart<Geometry>;
  result.geometry = prepared
                        .get<KeptGeometry>(key_in("working geometry", scene.geometry.revision(), space),
                                           [&] {
                                             return KeptGeometry{Part<Geometry>(moved(*scene.geometry, space)),
                                                                 scene.geometry->objects.size() * sizeof(Object)};
                                           })
                        ->part;
  using KeptLights = KeptPart<std::vector<Light>>;
  result.lights =
      prepared
          .get<KeptLights>(
              key_in("working lights", scene.lights.revision(), space).add(illumination),
              [&] {
                std::vector<Light> lights = moved(*scene.lights, space);
                for (Light& light : lights)  // a power that spreads over a sphere of the working space
                  if (light.kind == LightKind::point && illumination == Illumination::radiometric)
                    light.intensity *= space.scale * space.scale;
                return KeptLights{Part<std::vector<Light>>(std::move(lights)), scene.lights->size() * sizeof(Light)};
              })
          ->part;
  return result;
}

/// Lengths of the world among the settings.
Settings settings_in(Settings settings, double scale) {
  if (settings.self_hit == SelfHit::normal_bump || settings.epsilon_unit == EpsilonUnit::distance) {
    settings.shadow_epsilon *= scale;
    settings.reflection_epsilon *= scale;
  }
  settings.shadow_bias *= scale;
  settings.volume_length *= scale;
  settings.triangle_epsilon *= scale * scale * scale;  // a volume
  return settings;
}

}  // namespace

WorkingScene::WorkingScene(const Scene& given_scene, const View& given_view, const Settings& given_settings,
                           Prepared& prepared)
    : space(space_for(given_scene, given_settings, prepared)), scene_(given_scene), view_(given_view),
      settings_(given_settings) {
  if (space.is_world()) return;
  View view = view_;
  view.camera = moved(view_.camera, space);
  held_ = Held{scene_in(scene_, space, settings_.illumination, prepared), view, settings_in(settings_, space.scale)};
}

void WorkingScene::to_world(Frame& frame) const {
  if (space.scale == 1) return;
  const auto back = static_cast<float>(1 / space.scale);
  for (float& depth : frame.depth.pixels()) depth *= back;
  for (float& depth : frame.shadow_map.pixels())
    if (depth >= 0) depth *= back;
}

}  // namespace ps
