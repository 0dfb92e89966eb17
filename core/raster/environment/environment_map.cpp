#include "raster/environment/environment_map.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "frame/memory_need.h"
#include "options/option.h"
#include "raster/environment/draw_environment.h"
#include "raster/environment/map_sources.h"
#include "raster/shadow/map_picture.h"
#include "raster/shadow/shadow_map.h"

namespace ps::raster {
namespace {

constexpr double nearest_reflected = 1e-3;  // world units

/// The picture's own settings, except for the camera's and for mirrors, which show their local colour in a map.
Settings map_settings(const Settings& settings) {
  const Settings defaults;
  Settings plain = settings;
  plain.environment = Environment::none;
  plain.environment_objects = EnvironmentObjects::all;
  plain.projection = Projection::perspective;
  plain.viewport_fit = ViewportFit::height;
  plain.field_of_view_span = FieldOfViewSpan::edges;
  plain.sample_position = SamplePosition::centre;
  plain.near = nearest_reflected;
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

EnvironmentMap look_around(const Scene& scene, const Vec3d& centre, int left_out, const Settings& settings,
                           const DrawColours& draw) {
  EnvironmentMap map;
  map.centre = centre;
  map.size = settings.environment_size;
  map.left_out = left_out;
  for (const CubeFace& face : cube_faces()) {
    const View view{cube_camera(face, centre), map.size, map.size};
    map.faces.push_back(draw(scene, view, map_settings(settings)));
  }
  return map;
}

Vec3d centre_of(const Scene& scene, std::size_t object) {
  return shadow_casters(only(scene, [&](const Object&, std::size_t i) { return i == object; })).centre;
}

bool shows_static_only(const Settings& settings) { return settings.environment_objects == EnvironmentObjects::fixed; }

/// The objects that a map shows, as a number: the same while none of them changes, whatever others do.
template <class Keep>
std::uint64_t number_of_shown(const Scene& scene, Prepared& prepared, Keep&& keep) {
  MapSources sources;
  const auto& objects = scene.geometry->objects;
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (keep(objects[i])) sources.objects.emplace_back(i, objects[i]);
  sources.meshes = scene.geometry->meshes;
  const auto numbers =
      prepared.get<MapSourceNumbers>(Key("environment-map-sources"), [] { return MapSourceNumbers(); });
  return numbers->number_of(std::move(sources));
}

/// What all maps of a picture depend on, but for the objects in them. `of` names the map among the others.
Key map_key(std::string_view of, const Scene& scene, const Settings& settings) {
  Key key = Key(of)
                .add(scene.lights.revision())
                .add(scene.materials.revision())
                .add(scene.textures.revision())
                .add(std::uint64_t(settings.environment_size));
  for (int axis = 0; axis < 3; ++axis) key.add(scene.background[axis]);
  Settings plain = map_settings(settings);
  plain.threads = 0;
  plain.simd = Simd::automatic;
  for (const Option& option : option_table()) key.add(option.get(plain));
  return key;
}

/// The memory for the maps of `mirrors` objects.
MemoryNeed need_of(std::uint64_t mirrors, const Settings& settings, int copies) {
  const auto size = static_cast<std::uint64_t>(settings.environment_size);
  return {mirrors * 6 * size * size * sizeof(Vec3f) * static_cast<std::uint64_t>(copies),
          fmt::format("the environment maps of {} mirrors with {} x {} texels", mirrors, size, size),
          "set a smaller 'environment-size', or 'environment' to room-map"};
}

/// Makes the maps that are not in `prepared`.
class MapMaker {
 public:
  /// `mirrors` objects are going to ask for their maps, of which there will be `copies` each.
  MapMaker(const Scene& scene, const Settings& settings, Prepared& prepared, std::uint64_t mirrors, int copies,
           const DrawColours& draw)
      : scene_(scene), settings_(settings), prepared_(prepared), left_(mirrors), copies_(copies), draw_(draw),
        fixed_only_(shows_static_only(settings)) {}

  /// The map of a mirror: all other objects, or the static ones among them. One that shows static objects alone depends
  /// on none that moves but on its own place.
  std::shared_ptr<const EnvironmentMap> around(std::size_t mirror) {
    const auto& objects = scene_.geometry->objects;
    const auto dynamic = static_cast<int>(std::count_if(objects.begin(), objects.end(), is_dynamic));
    const int left_out = fixed_only_ ? dynamic - (objects[mirror].dynamic ? 1 : 0) : 0;
    Key key = map_key(fmt::format("environment-map/{}", mirror), scene_, settings_)
                  .add(shown_to_mirrors())
                  .add(static_cast<std::uint64_t>(left_out));
    const Vec3d centre = centre_of(scene_, mirror);
    for (int axis = 0; axis < 3; ++axis) key.add(centre[axis]);
    const std::uint64_t still_to_make = left_--;
    return prepared_.get<EnvironmentMap>(key, [&] {
      if (!asked_) require(need_of(still_to_make, settings_, copies_), prepared_);
      asked_ = true;
      const Scene shown =
          only(scene_, [&](const Object& o, std::size_t k) { return k != mirror && !(fixed_only_ && o.dynamic); });
      return look_around(shown, centre, left_out, settings_, draw_);
    });
  }

  /// The one map of the room.
  std::shared_ptr<const EnvironmentMap> of_room() {
    const auto matte = [&](const Object& o) { return !(reflective(scene_, o) > 0); };
    const auto keep = [&](const Object& o) { return matte(o) && !(fixed_only_ && o.dynamic); };
    const auto& objects = scene_.geometry->objects;
    const auto left_out = static_cast<int>(
        std::count_if(objects.begin(), objects.end(), [&](const Object& o) { return matte(o) && !keep(o); }));
    const Key key = map_key("environment-map/room", scene_, settings_)
                        .add(number_of_shown(scene_, prepared_, keep))
                        .add(static_cast<std::uint64_t>(left_out));
    return prepared_.get<EnvironmentMap>(key, [&] {
      require(need_of(1, settings_, copies_), prepared_);
      const Scene room = only(scene_, [&](const Object& o, std::size_t) { return keep(o); });
      return look_around(room, shadow_casters(room).centre, left_out, settings_, draw_);
    });
  }

 private:
  static bool is_dynamic(const Object& object) { return object.dynamic; }

  std::uint64_t shown_to_mirrors() {
    if (!fixed_only_) return scene_.geometry.revision();
    if (!shown_) shown_ = number_of_shown(scene_, prepared_, [](const Object& o) { return !o.dynamic; });
    return *shown_;
  }

  const Scene& scene_;
  const Settings& settings_;
  Prepared& prepared_;
  std::uint64_t left_;  ///< mirrors that have not asked
  const int copies_;
  bool asked_ = false;  ///< for the memory of all that are left
  const DrawColours& draw_;
  const bool fixed_only_;
  std::optional<std::uint64_t> shown_;
};

}  // namespace

bool uses_environment(const Settings& settings, const Scene& scene) {
  return settings.environment != Environment::none && fills(settings.draw) && scene_traits(scene).reflective;
}

std::shared_ptr<const EnvironmentMaps> draw_environment_maps(const Scene& scene, const Settings& settings,
                                                             Prepared& prepared, int copies, const DrawColours& draw) {
  const auto& objects = scene.geometry->objects;
  auto maps = std::make_shared<EnvironmentMaps>(objects.size());
  const auto mirrors =
      std::count_if(objects.begin(), objects.end(), [&](const Object& o) { return reflective(scene, o) > 0; });
  MapMaker maker(scene, settings, prepared, static_cast<std::uint64_t>(mirrors), copies, draw);
  std::shared_ptr<const EnvironmentMap> room;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (!(reflective(scene, objects[i]) > 0)) continue;
    switch (settings.environment) {
    case Environment::none:
      break;
    case Environment::cube_map:
      (*maps)[i] = maker.around(i);
      break;
    case Environment::room_map:
      if (!room) room = maker.of_room();
      (*maps)[i] = room;
      break;
    }
  }
  return maps;
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
