#pragma once
#include <string>
#include <string_view>

namespace ps {

/// "shadows=none" as the option table writes it for people: "Shadows: none". Text that is not such an assignment comes
/// back as it is.
std::string setting_words(std::string_view assignment);

/// Every assignment of a list in setting_words(); the parts are separated by `separator`, as in "double,
/// self-hit=offset".
std::string settings_in_words(std::string_view text, std::string_view separator = ", ");

}  // namespace ps
