#pragma once
#include <string>
#include <vector>

#include "options/settings.h"
#include "scene/scene.h"

namespace ps {

/// The settings that a scene starts with: the defaults with what its file asks for. Throws InputError for a setting
/// that the option table does not have or that is out of range.
Settings settings_for(const Scene& scene);

/// The assignments "key=value", in table order, that turn `from` into `to`.
std::vector<std::string> settings_difference(const Settings& from, const Settings& to);

}  // namespace ps
