#pragma once
#include <vector>

#include "raster/setup/tessellate.h"
#include "scene/patch.h"

namespace ps::raster {

inline constexpr int most_patch_divisions = 64;

/// Into how many parts each edge of the patches is cut so that no triangle strays from the surface by more than
/// view.max_error pixels (LAB 7; capability B19). One number for all patches, as edges that they share would crack
/// otherwise. `world` holds the patches in world space. At most most_patch_divisions, whatever the error then is.
///
/// A triangle that spans 1 / n of u and of v strays from a surface P by at most (|Puu| + 2 |Puv| + |Pvv|) / 8 n^2
/// (Filip, Magedson and Markot 1986). Only what bends away along the normal is seen; it is taken at points of each
/// patch, with a tenth added for what lies between them.
int patch_divisions(const std::vector<BezierPatch>& world, const TessellationView& view);

}  // namespace ps::raster
