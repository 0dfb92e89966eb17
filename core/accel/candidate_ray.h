#pragma once
#include "accel/slab.h"

namespace ps {

/// A ray as accelerators see it. They must not turn away anything within `pad` of it: primitive tests in finite
/// precision accept rays that pass by at some rounding errors' distance.
template <class Real>
struct CandidateRay {
  Vec3<Real> origin{0}, direction{0};
  Real pad = 0;
  SlabForm form = SlabForm::robust;

  /// Made ready for boxes, which are grown by `pad`; the naive test grows none.
  SlabRay<Real> slabs() const {
    return SlabRay<Real>(origin, direction, form == SlabForm::naive ? Real(0) : pad, form);
  }
};

}  // namespace ps
