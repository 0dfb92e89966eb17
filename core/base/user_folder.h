#pragma once
#include <filesystem>

namespace ps {

/// The folder that a variable such as XDG_STATE_HOME names, or `below_home` in the user's home folder; empty if neither
/// is known. A relative path counts as none, as the XDG Base Directory Specification has it: it would depend on where
/// the program is started.
std::filesystem::path user_folder(const char* variable, const char* below_home);

}  // namespace ps
