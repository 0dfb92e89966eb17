#pragma once
#include "scene/generate/bezier_patch.h"

namespace ps {

/// Newell's teapot of 1975 had 28 patches and no bottom; the published data adds four for it.
enum class TeapotBottom { closed, open };

struct TeapotOptions {
  int divisions = 10;  ///< of each patch's edge; n gives 64 n^2 - 8 n triangles with bottom: 6,320 for 10
  TeapotBottom bottom = TeapotBottom::closed;
};

/// Martin Newell's Utah teapot as published (his dissertation, University of Utah, 1975; lowered by a factor 1.3 by
/// Blinn, as everybody knows it): 32 bicubic patches with z up, the spout towards +x, standing on z = 0, 3.15 high.
/// Patches come in the published order: rim 4, body 8, handle 4, spout 4, lid 8, bottom 4; fronts face outwards.
std::vector<BezierPatch> teapot_patches(TeapotBottom bottom = TeapotBottom::closed);

/// The patches, tessellated. The surface is not closed: there is a gap between rim and lid, the spout is open at its
/// tip, and handle and spout run into the body without being joined to it.
Mesh make_teapot(const TeapotOptions& options = {});

}  // namespace ps
