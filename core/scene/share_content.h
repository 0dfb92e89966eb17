#pragma once
#include "scene/scene.h"

namespace ps {

/// Lets meshes and texels that `scene` has in common with `earlier` be those of the earlier one, so that they are held
/// once however often a file is opened. Two of the same number in both scenes are compared in full.
Scene share_content(Scene scene, const Scene& earlier);

}  // namespace ps
