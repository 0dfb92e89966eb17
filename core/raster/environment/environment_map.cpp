#include "raster/environment/environment_map.h"

#include <algorithm>

#include "options/option.h"
#include "raster/environment/map_sources.h"
#include "raster/renderer.h"
#include "raster/shadow/map_picture.h"
#include "raster/shadow/shadow_map.h"

namespace ps::raster {
namespace {

constexpr double near_limit = 1e-3;  // world units

/// The picture's own settings, except for the camera's and for mirrors, which show their local colour in a map.
Settings map_settings(const Settings& settings) {
  const Settings defaults;
  Settings plain = settings;
  plain.renderer = Renderer::rasterizer;
  plain.environment = Environment::none;
  plain.environment_objects = EnvironmentObjects::all;
  plain.projection = Projection::perspective;
  plain.viewport_fit = ViewportFit::height;
  plain.field_of_view_span = FieldOfViewSpan::edges;
  plain.sample_position = SamplePosition::centre;
  plain.near = near_limit;
  plain.far = defaults.far;
  plain.clipping = Clipping::full;
  plain.draw = Draw::filled;
  plain.exposure = defaults.exposure;
  plain.gamma = defaults.gamma;
  plain.colour_depth = defaults.colour_depth;
  return plain;
}

/// An object's reflectivity: the largest of its materials.
double reflective(const Scene& scene, const Object& object) {
  const auto of = [&](std::uint32_t material) { return scene.materials->at(material).reflective; };
  if (const auto* sphere = std::get_if<Sphere>(&object.shape)) return of(sphere->material);
  if (const auto* solid = std::get_if<Solid>(&object.shape)) return of(solid->material);
  const auto* instance = std::get_if<Instance>(&object.shape);
  if (!instance) return 0;
  if (instance->material) return of(*instance->material);
  double most = 0;
  for (const std::uint32_t slot : scene.geometry->meshes.at(instance->mesh)->materials) most = std::max(most, of(slot));
  return most;
}

/// The scene's objects for which keep(object, index) holds, and no shapes on the canvas.
template <class Keep>
Scene only(const Scene& scene, Keep&& keep) {
  Scene rest = scene;
  rest.canvas_items = {};
  rest.geometry.edit([&](Geometry& geometry) {
    std::vector<Object> kept;
    for (std::size_t i = 0; i < geometry.objects.size(); ++i)
      if (keep(geometry.objects[i], i)) kept.push_back(geometry.objects[i]);
    geometry.objects = std::move(kept);
  });
  return rest;
}

std::shared_ptr<const EnvironmentMap> look_around(const Scene& scene, const Vec3d& centre, int left_out,
                                                  const Settings& settings, WorkerPriority priority,
                                                  Progress& progress) {
  Prepared own;  // the scene is one of its own; its products would push out the picture's
  RenderRequest request;
  request.priority = priority;
  auto map = std::make_shared<EnvironmentMap>();
  map->centre = centre;
  map->size = settings.environment_size;
  map->left_out = left_out;
  for (const CubeFace& face : cube_faces()) {
    const View view{cube_camera(face, centre), map->size, map->size};
    map->faces.push_back(render_rasterized(scene, view, map_settings(settings), request, own, progress).colour);
  }
  return map;
}

Vec3d centre_of(const Scene& scene, std::size_t object) {
  return shadow_casters(only(scene, [&](const Object&, std::size_t i) { return i == object; })).centre;
}

bool shows_static_only(const Settings& settings) {
  return settings.environment == Environment::cube_map && settings.environment_objects == EnvironmentObjects::fixed;
}

MapSources map_sources(const Scene& scene) {
  MapSources sources;
  const auto& objects = scene.geometry->objects;
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (!objects[i].dynamic || reflective(scene, objects[i]) > 0) sources.objects.emplace_back(i, objects[i]);
  sources.meshes = scene.geometry->meshes;
  sources.scene_objects = objects.size();
  return sources;
}

/// What the maps show of the scene's geometry, as a number.
std::uint64_t shown_geometry(const Scene& scene, const Settings& settings, Prepared& prepared) {
  if (!shows_static_only(settings)) return scene.geometry.revision();
  const auto numbers =
      prepared.get<MapSourceNumbers>(Key("environment-map-sources"), [] { return MapSourceNumbers(); });
  return numbers->number_of(map_sources(scene));
}

Key map_key(const Scene& scene, const Settings& settings, Prepared& prepared) {
  Key key = Key("environment-maps")
                .add(shown_geometry(scene, settings, prepared))
                .add(scene.lights.revision())
                .add(scene.materials.revision())
                .add(scene.textures.revision())
                .add(settings.environment)
                .add(settings.environment_objects)
                .add(std::uint64_t(settings.environment_size));
  for (int axis = 0; axis < 3; ++axis) key.add(scene.background[axis]);
  Settings plain = map_settings(settings);
  plain.threads = 0;
  plain.simd = Simd::automatic;
  for (const Option& option : option_table()) key.add(option.get(plain));
  return key;
}

}  // namespace

bool uses_environment(const Settings& settings, const Scene& scene) {
  return settings.environment != Environment::none && settings.draw == Draw::filled && scene_traits(scene).reflective;
}

std::shared_ptr<const EnvironmentMaps> environment_maps(const Scene& scene, const Settings& settings,
                                                        Prepared& prepared, WorkerPriority priority,
                                                        Progress& progress) {
  return prepared.get<EnvironmentMaps>(map_key(scene, settings, prepared), [&] {
    const auto& objects = scene.geometry->objects;
    EnvironmentMaps maps(objects.size());
    std::shared_ptr<const EnvironmentMap> room;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      if (!(reflective(scene, objects[i]) > 0)) continue;
      switch (settings.environment) {
      case Environment::none:
        break;
      case Environment::cube_map: {
        const bool fixed_only = shows_static_only(settings);
        const Scene shown =
            only(scene, [&](const Object& o, std::size_t k) { return k != i && !(fixed_only && o.dynamic); });
        const auto left_out = static_cast<int>(objects.size() - 1 - shown.geometry->objects.size());
        maps[i] = look_around(shown, centre_of(scene, i), left_out, settings, priority, progress);
        break;
      }
      case Environment::room_map:
        if (!room) {
          const Scene fixed = only(scene, [&](const Object& o, std::size_t) { return !(reflective(scene, o) > 0); });
          room = look_around(fixed, shadow_casters(fixed).centre, 0, settings, priority, progress);
        }
        maps[i] = room;
        break;
      }
    }
    return maps;
  });
}

void lay_out_environment(const EnvironmentMap& map, Image<Vec3f>& picture) {
  const int side = std::max(std::min(picture.width() / 4, picture.height() / 3), 1);
  for (int face = 0; face < 6; ++face) {
    const Vec2i cell = cross_cell(face);
    const Image<Vec3f>& texels = map.faces[static_cast<std::size_t>(face)];
    each_pixel(
        cell.x * side, cell.y * side, side, picture.width(), picture.height(), [&](int x, int y, double u, double v) {
          picture.at(x, y) = texels.at(static_cast<int>(u * texels.width()), static_cast<int>(v * texels.height()));
        });
  }
}

}  // namespace ps::raster
