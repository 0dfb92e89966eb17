#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace ps {

/// The command that runs `program` in bubblewrap: with the system's libraries, its own folder and `folder`, the only
/// one that it can write to. Empty where there is no bubblewrap or the system does not let it work.
std::vector<std::string> isolated_command(const std::filesystem::path& program, const std::filesystem::path& folder);

}  // namespace ps
