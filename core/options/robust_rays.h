#pragma once
#include "options/settings.h"

namespace ps {

/// The settings with the rays that err least: in double, each test in its robust form, found through the tree.
inline Settings robust_rays(Settings settings) {
  settings.precision = Precision::float64;
  settings.accelerator = Accelerator::bvh;
  settings.slab_test = SlabTest::robust;
  settings.triangle_test = TriangleTest::watertight;
  settings.sphere_test = SphereTest::robust;
  return settings;
}

}  // namespace ps
