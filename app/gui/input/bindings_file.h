#pragma once
#include <filesystem>
#include <string>

#include "gui/input/actions.h"

namespace ps::gui {

/// Binds keys as a file says ("action = keys" on each line); a missing file binds nothing. Returns why it was ignored:
/// "FILE:LINE: found ..., expected ..."; "" if it was not.
std::string load_bindings(const std::filesystem::path& path, Actions& actions);

}  // namespace ps::gui
