#pragma once
#include <optional>

#include "raster/clear/depth_test.h"
#include "raster/clear/shade_fragment.h"
#include "record/recorder.h"

namespace ps::raster {

/// Replays which of the triangles that cover a sample the picture shows there: they are offered in drawing order, with
/// the depths that the depth buffer compares, those that an opacity map cuts out left out.
template <class Real>
class SampleWinner {
 public:
  explicit SampleWinner(const Pass<Real>& pass)
      : pass_(pass), compares_(pass.settings.visibility == Visibility::depth_buffer),
        stored_(empty_depth<Real>(pass.depth)) {}

  /// The depth of a fragment as it is compared: encoded, at the sample that lies at `in_pixel` in its pixel.
  static Real depth(const Pass<Real>& pass, const TriangleSetup<Real>& setup, const Fragment<Real>& fragment,
                    const Vec2d& in_pixel) {
    return pass.depth.encode(depth_value(pass, setup, fragment, in_pixel));
  }
  /// Whether an opacity map cuts the fragment out, so that it is never offered.
  static bool cut_out(const Pass<Real>& pass, const TriangleSetup<Real>& setup, const Fragment<Real>& fragment) {
    CountingRecorder recorder;
    return is_cut_out(pass, setup, fragment, recorder);
  }

  /// The next triangle of the drawing order, by whatever number the caller gives it.
  void offer(int number, Real depth) {
    if (compares_ && !is_nearer(pass_.depth, depth, stored_)) return;
    stored_ = depth;
    winner_ = number;
  }
  /// The number of the one that is seen; -1 where there is none.
  int winner() const { return winner_; }

 private:
  const Pass<Real>& pass_;
  bool compares_;
  Real stored_;
  int winner_ = -1;
};

}  // namespace ps::raster
