#pragma once
#include <vector>

#include "frame/frame.h"
#include "options/settings.h"
#include "scene/light.h"
#include "scene/material.h"
#include "scene/mesh.h"

namespace ps::raster {

/// Which values are carried across the triangles of one surface, and where each starts in a vertex's list of scalars;
/// absent = not needed, so not interpolated. Constants of a triangle (flat light, triangle normal) are not among them.
struct AttributeLayout {
  static constexpr int absent = -1;
  int normal = absent;    ///< 3 scalars, world space
  int position = absent;  ///< 3 scalars, world space
  int uv = absent;        ///< 2 scalars
  int tangents = absent;  ///< 6 scalars, the same at each vertex: TangentFrame, world space
  int light = absent;     ///< 3 scalars: light from the vertices (Gouraud)
  int extra = absent;     ///< 3 scalars: light with a colour of its own (Gouraud)
  int count = 0;          ///< scalars in all

  bool lit = false;             ///< the illumination equation is used at all
  bool flat_light = false;      ///< once for each triangle
  bool mapped_normal = false;   ///< the normal map turns it
  bool relief = false;          ///< parallax mapping moves the texture coordinates
  bool light_maps = false;      ///< maps of highlights or ambient light change the material at each pixel
  bool reflection_map = false;  ///< a picture shows what the surface reflects
  bool shading_normal = false;  ///< some consumer needs a normal at each pixel
};

/// What the scene's lights need to know about a surface point.
struct LightNeeds {
  bool any = false;     ///< there is a light
  bool normal = false;  ///< a point or directional light
  bool point = false;   ///< a point light
};
LightNeeds light_needs(const std::vector<Light>& lights);

/// No more than this material, these lights and these channels need.
AttributeLayout make_layout(const Settings& settings, const LightNeeds& lights, const Material& material,
                            const Mesh& mesh, Channel channels);

}  // namespace ps::raster
