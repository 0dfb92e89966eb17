#pragma once
#include "math/vec.h"
#include "raster/setup/projection.h"
#include "scene/mesh.h"
#include "scene/object.h"

namespace ps::raster {

/// Can the side of a sphere that is turned away from the eye matter? With `hidden` a sphere of many triangles is only
/// its visible cap; with `seen` it is always a closed surface: where backs are drawn, since they are seen through the
/// opening that the near plane cuts, and where stencil shadows are cast, by the side that faces the light.
enum class FarSide { hidden, seen };

/// From where a tessellation will be seen, and how exact it must be.
struct TessellationView {
  Vec3d eye{0, 0, 0};      ///< world space
  Vec3d forward{0, 0, 1};  ///< towards the scene; decides alone in orthographic pictures
  Projection projection = Projection::perspective;
  /// Pixels that a length of 1 across the line of sight takes at a distance of 1 (perspective) or at any
  /// (orthographic), where the picture magnifies most.
  double pixels_per_unit = 600;
  double nearest = 1;      ///< world units; nothing nearer is seen
  double max_error = 0.5;  ///< pixels
  FarSide far_side = FarSide::hidden;
};

TessellationView make_tessellation_view(const Camera& camera, const Viewport<double>& viewport, double near,
                                        double max_error);

/// Triangles for a sphere (LAB 7; capability B19), in world space, outward facing, with the sphere's own normals. Rings
/// around the axis towards the eye are spaced so that no triangle strays from the sphere by more than max_error pixels;
/// one ring is the outline itself. A sphere that would take too many triangles (the book's ground, radius 5000) is a
/// cap, unless its far side is seen: the part that can be seen, from the point nearest the eye to the horizon.
Mesh tessellate_sphere(const Sphere& sphere, const TessellationView& view);

/// How many triangles that mesh has, without making it.
std::uint64_t sphere_triangles(const Sphere& sphere, const TessellationView& view);

}  // namespace ps::raster
