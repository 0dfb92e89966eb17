#pragma once
#include "raster/setup/tessellate.h"
#include "scene/solid.h"

namespace ps::raster {

/// Triangles for a solid in world space, outward facing, with normals and texture coordinates (CGFS ch. 5). Rectangles
/// and planes with two sides come as two layers, front and back. A plane becomes a disc of rings around the point below
/// the eye, wide enough that its edge lies within a pixel of the horizon. Round sides stray from the cylinder by at
/// most max_error pixels. Throws InputError for a solid or a view that is not finite.
Mesh tessellate_solid(const Solid& solid, const TessellationView& view);

/// How many triangles that mesh has, without making it.
std::uint64_t solid_triangles(const Solid& solid, const TessellationView& view);

/// Texture coordinates of the world map (scene/uv_maps.h) for a sphere's mesh. Triangles on the seam get coordinates
/// beyond 1, which a repeating texture wraps.
void add_world_map_uvs(Mesh& mesh, const Vec3d& centre);

}  // namespace ps::raster
