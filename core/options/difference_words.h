#pragma once
#include <string>

#include "options/option.h"

namespace ps {

/// The value of an option as part of a caption: "ray tracer", "shading: flat", "without highlights", "reflection depth
/// 3".
std::string setting_words(const Option& option, const Settings& settings);

/// The settings of `of` that `other` does not have, in table order: "ray tracer, reflection depth 3"; empty if they are
/// equal. A planted bug is not named, since students are to find it.
std::string difference_words(const Settings& of, const Settings& other);

}  // namespace ps
