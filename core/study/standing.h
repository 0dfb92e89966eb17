#pragma once
#include <string_view>

#include "study/reference.h"

namespace ps {

/// What a picture is to the truth that a study compares it with.
enum class Standing {
  compared,       ///< it has an error
  truth,          ///< it has the settings of the truth, but for rounding: no error of its own
  other_picture,  ///< it shows something else on purpose (TruthKind::other_picture): its difference is no error
};

/// The standing of each of the plan's points, in their order. Where all of them have the settings of the truth, as with
/// options that only change the speed, none is drawn as the truth: all are compared. Where none has an error, as with
/// the gamma, the picture as set is one of those on purpose.
std::vector<Standing> standings(std::span<const SweepPoint> points, const ReferencePlan& plan,
                                const SceneTraits& traits);

}  // namespace ps
