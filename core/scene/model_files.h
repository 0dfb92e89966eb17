#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ps {

/// Finds the files that models name, as exporters write them: with paths of another machine, with backslashes, in
/// quotes, and in other case than the file has, which Windows does not mind. Folders are listed once.
class ModelFiles {
 public:
  /// The first regular file of these in `folders`, in their order: the name with its path, the name alone, then both
  /// without regard to the case of ASCII letters. nullopt if there is none.
  std::optional<std::filesystem::path> find(const std::vector<std::filesystem::path>& folders, std::string name);

 private:
  using Listing = std::map<std::string, std::string>;  ///< name in small letters -> name
  std::optional<std::filesystem::path> find_in_any_case(const std::filesystem::path& folder,
                                                        const std::filesystem::path& name);
  const Listing& listing_of(const std::filesystem::path& folder);

  std::map<std::filesystem::path, Listing> listings_;
};

}  // namespace ps
