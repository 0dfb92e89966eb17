#pragma once
#include <string>
#include <string_view>

#include "options/option.h"
#include "options/settings.h"

namespace ps {

/// Whether it switches the option's technique off: shadows = none, specular = off, reflection-depth = 0.
bool is_without(const Option& option, const Settings& settings);

/// One setting as people read it: "shading: flat", "without shadows", "in world coordinates", "reflection depth 3".
std::string setting_words(const Option& option, const Settings& settings);
/// The label of a choice's value, as panels show it; any other value as it is.
std::string value_label(const Option& option, std::string_view value);
/// That of the assignment "shading=flat". Text that is not such an assignment comes back as it is.
std::string setting_words(std::string_view assignment);
/// Every assignment of a list in setting_words(); the parts are separated by `separator`, as in "double,
/// self-hit=offset".
std::string settings_in_words(std::string_view text, std::string_view separator = ", ");

/// The settings of `of` that `other` does not have, in table order: "ray tracer, shading: flat, without highlights,
/// reflection depth 3"; empty if they are equal. A planted bug is not named, since students are to find it.
std::string difference_words(const Settings& of, const Settings& other);

}  // namespace ps
