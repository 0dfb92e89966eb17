#pragma once
#include <string>

#include "options/option.h"
#include "options/settings.h"

namespace ps {

/// One setting as it reads in a caption: "shading: flat", "without highlights", "reflection depth 3".
std::string caption_words(const Option& option, const Settings& settings);

/// The settings of `of` that `other` does not have, in table order: "ray tracer, shading: flat, without highlights,
/// reflection depth 3"; empty if they are equal. A planted bug is not named, since students are to find it.
std::string difference_words(const Settings& of, const Settings& other);

}  // namespace ps
