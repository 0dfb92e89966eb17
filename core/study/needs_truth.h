#pragma once
#include "study/reference.h"

namespace ps {

/// What the search for a scene's needs measures with.
struct NeedsTruth {
  ReferencePlan plan;  ///< the truth, as plan_reference() decides it for every picture that may be tried
  /// The settings asked about with the exact values of what is searched, by the same renderer and samples: the best
  /// that their way of drawing can do.
  Settings exact;
};

/// Where the settings ask a renderer for fragments to trace shadows, they ask for none. No more than 12 bounces are
/// taken for the truth, or as many as `base` has: what is left after them is below what FLIP sees.
NeedsTruth needs_truth(const Settings& base, const SceneTraits& traits, const View& view);

}  // namespace ps
