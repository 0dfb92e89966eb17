#pragma once
#include <filesystem>
#include <map>
#include <string>

namespace ps::gui {

/// What the window remembers from one start to the next, as text by key, in a JSON file in the user's state folder
/// ($XDG_STATE_HOME or ~/.local/state, then pixelscope/window.json). A missing or damaged file counts as empty; a
/// folder that cannot be written is ignored: remembering is a convenience.
class StateFile {
 public:
  /// An empty path remembers nothing.
  explicit StateFile(std::filesystem::path path);
  static std::filesystem::path default_path();

  bool remembers() const { return !path_.empty(); }
  std::string get(const std::string& key) const;
  void set(const std::string& key, std::string value);
  /// Writes the file (a temporary one, then a rename) if something changed since the last time.
  void save();

 private:
  std::filesystem::path path_;
  std::map<std::string, std::string> entries_;
  bool changed_ = false;
};

/// A file of the user's configuration folder ($XDG_CONFIG_HOME or ~/.config, then pixelscope/NAME).
std::filesystem::path config_file(const std::string& name);

}  // namespace ps::gui
