#include "raster/setup/surface.h"

#include "scene/world.h"

namespace ps::raster {

template <class Real>
Surfaces<Real> make_surfaces(const Scene& scene, const std::vector<DrawObject>& objects, const Settings& settings,
                             Channel channels) {
  Surfaces<Real> surfaces;
  const LightNeeds needs = light_needs(*scene.lights);
  for (const DrawObject& object : objects) {
    surfaces.first.push_back(static_cast<std::uint32_t>(surfaces.list.size()));
    for (const std::uint32_t index : object.materials) {
      const Material& material = scene.materials->at(index);
      Surface<Real> surface;
      surface.object = object.object;
      surface.drawn = surfaces.first.size() - 1;
      surface.sphere = object.sphere;
      surface.layout = make_layout(settings, needs, material, *object.mesh, channels);
      surface.material = shading_material<Real>(material);
      const AttributeLayout& layout = surface.layout;
      if (layout.mapped_normal && settings.mapped_normals == MappedNormals::inverse_transpose)
        surface.placing =
            placing_of<Real>(linear_part(scene.geometry->objects[static_cast<std::size_t>(object.object)]));
      surfaces.textured = surfaces.textured || layout.tangents != AttributeLayout::absent || layout.reflection_map ||
                          (settings.textures && layout.uv != AttributeLayout::absent && needs_uv(material));
      surfaces.list.push_back(std::move(surface));
    }
  }
  return surfaces;
}

template Surfaces<float> make_surfaces(const Scene&, const std::vector<DrawObject>&, const Settings&, Channel);
template Surfaces<double> make_surfaces(const Scene&, const std::vector<DrawObject>&, const Settings&, Channel);

}  // namespace ps::raster
