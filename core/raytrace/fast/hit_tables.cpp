#include "raytrace/fast/plain_material.h"
#include "raytrace/fast/shade_hits.h"
#include "shade/faint_highlight.h"

namespace ps {
namespace {

/// Is the colour of such a surface the material's times the light, without further rays?
bool is_plain(const ShadingMaterial<float>& material, const Settings& settings) {
  const bool further_rays = settings.reflection_depth > 0 && (material.reflective > 0 || material.transparency > 0);
  return has_plain_light(material) && !further_rays && material.height_map < 0;
}

HitMaterial hit_material(const ShadingMaterial<float>& material, const Settings& settings) {
  HitMaterial row;
  row.red = material.colour.x;
  row.green = material.colour.y;
  row.blue = material.colour.z;
  row.exponent = material.specular.value_or(1.0f);
  row.faint = faint_cosine(row.exponent);
  row.specular = settings.specular && material.specular ? 1.0f : 0.0f;
  return row;
}

}  // namespace

std::optional<HitTables> hit_tables(const TraceInputs<float>& inputs) {
  const TracedGeometry<float>& geometry = *inputs.geometry;
  const Settings& settings = inputs.settings;
  if (inputs.path.machinery != Machinery::wide_triangles || inputs.path.shading == SurfaceShading::single) return {};
  if (geometry.triangles.empty() && !shares_meshes(geometry)) return {};
  HitTables tables;
  const HitFunctions functions = hit_functions(settings.simd);
  tables.place = functions.place;
  tables.light = functions.light;
  if (tables.light == nullptr) return {};
  static_assert(sizeof(TracedTriangle<float>) == 10 * sizeof(float));
  static_assert(sizeof(TriangleAttributes<float>) == 16 * sizeof(float));
  if (!geometry.triangles.empty()) tables.triangles = &geometry.triangles[0].a.x;
  if (!geometry.attributes.empty()) tables.attributes = &geometry.attributes[0].normals[0].x;
  bool any = false;
  for (const ShadingMaterial<float>& material : inputs.materials) {
    const bool plain = is_plain(material, settings);
    any = any || plain;
    tables.plain.push_back(plain ? 1 : 0);
    tables.materials.push_back(hit_material(material, settings));
  }
  if (!any) return {};
  tables.lights = inputs.lights;
  tables.lighting = settings.lighting;
  tables.renormalise = settings.renormalise;
  tables.highlight = settings.highlight;
  return tables;
}

}  // namespace ps
