#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "frame/left_out.h"

namespace ps {

/// What a picture of such a scene leaves out when it is drawn triangle by triangle, by any renderer. `subject` names
/// the renderer at the beginning of a sentence.
std::vector<LeftOut> left_out_by_fragments(const SceneTraits& traits, const Settings& settings,
                                           std::string_view subject);

/// That float rounds the points that fragments light, or where vertices lie, so far that it is seen; `remedy` is what
/// computes in double. Null if it does not.
std::optional<LeftOut> rounded_by_fragments(const SceneTraits& traits, const Settings& settings,
                                            std::string_view subject, const Remedy& remedy);

}  // namespace ps
