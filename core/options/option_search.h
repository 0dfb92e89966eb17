#pragma once
#include <string_view>

#include "options/option.h"

namespace ps {

/// Whether an option is found by what a person types: every word must occur in its key, label, group, help, keywords or
/// the labels of its values.
bool option_matches(const Option& option, std::string_view wanted);

}  // namespace ps
