#include "raster/setup/attributes.h"

namespace ps::raster {

LightNeeds light_needs(const std::vector<Light>& lights) {
  LightNeeds needs;
  for (const Light& light : lights) {
    needs.any = true;
    needs.normal = needs.normal || light.kind != LightKind::ambient;
    needs.point = needs.point || light.kind == LightKind::point;
  }
  return needs;
}

AttributeLayout make_layout(const Settings& settings, const LightNeeds& lights, const Material& material,
                            const Mesh& mesh, Channel channels) {
  AttributeLayout layout;
  const auto take = [&](int& slot, int scalars) {
    slot = layout.count;
    layout.count += scalars;
  };
  const bool vertex_normals = settings.normals == Normals::vertex && !mesh.normals.empty();
  const bool per_pixel = settings.lighting && settings.shading == Shading::phong;
  const bool normal_channel = has(channels, Channel::normal);
  layout.lit = settings.lighting;
  layout.flat_light = settings.lighting && settings.shading == Shading::flat;
  const bool looks_up = settings.lighting && settings.shadows == Shadows::map && lights.normal;
  layout.light_maps =
      settings.textures && per_pixel && !mesh.uvs.empty() && (material.specular_map >= 0 || material.ambient_map >= 0);
  layout.reflection_map =
      settings.textures && settings.reflection_depth > 0 && material.reflective > 0 && material.reflection_map >= 0;
  const bool mirrors = layout.reflection_map || (settings.environment != Environment::none && material.reflective > 0);
  layout.relief = settings.parallax != Parallax::off && material.height_map >= 0 && !mesh.uvs.empty();
  layout.shading_normal = layout.relief || (per_pixel && lights.normal) || normal_channel || looks_up || mirrors;
  // Flat shading uses one normal for the whole triangle, also where it is only shown.
  if (layout.shading_normal && vertex_normals && settings.shading != Shading::flat) take(layout.normal, 3);
  const bool highlights = settings.specular && material.specular && lights.normal;
  if (looks_up || mirrors || layout.relief || (per_pixel && (lights.point || highlights))) take(layout.position, 3);
  const bool textured = settings.textures && (material.texture >= 0 || layout.light_maps || material.opacity_map >= 0);
  layout.mapped_normal = settings.normal_mapping && material.normal_map >= 0 && layout.shading_normal &&
                         settings.shading == Shading::phong && !mesh.uvs.empty();
  if (!mesh.uvs.empty() && (textured || layout.mapped_normal || layout.relief || has(channels, Channel::uv)))
    take(layout.uv, 2);
  if (layout.mapped_normal || layout.relief) take(layout.tangents, 6);
  if (settings.lighting && settings.shading == Shading::gouraud) {
    take(layout.light, 3);
    const bool tinted =
        material.specular_colour || material.ambient_colour || material.specular_map >= 0 || material.ambient_map >= 0;
    if (tinted) take(layout.extra, 3);
  }
  return layout;
}

}  // namespace ps::raster
