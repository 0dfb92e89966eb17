#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace ps::gui {

/// The window's memory from one start to the next, as text by key, in a JSON file in the user's state folder
/// ($XDG_STATE_HOME or ~/.local/state, then pixelscope/window.json). A missing file counts as empty; a damaged one too,
/// with a complaint, and it is kept as window.json.damaged; so is one of another version, as window.json.old. What
/// cannot be read or written is not remembered: remembering is a convenience. Several windows may use the same file.
class StateFile {
 public:
  /// With an empty path it is not stored.
  explicit StateFile(std::filesystem::path path);
  static std::filesystem::path default_path();

  bool remembers() const { return !path_.empty(); }
  std::string get(const std::string& key) const;
  /// The number of a key from `low` to `high`; 0 if there is none, with a complaint if there is something else.
  double number(const std::string& key, double low, double high);
  void set(const std::string& key, std::string value);
  /// The same for a list with an entry on each line: entries that another window has added since the file was read are
  /// not lost, they follow the first one.
  void set_lines(const std::string& key, std::string lines);
  /// Takes what changed since the last time over into the file as it is now. Of several windows one saves at a time,
  /// by a lock on the file of that name with .lock behind it, which stays; waits for the others a few seconds at most.
  void save();

  /// One sentence for each thing that was ignored, with the file's name.
  const std::vector<std::string>& complaints() const { return complaints_; }
  void complain(const std::string& key, const std::string& expected);

 private:
  using Entries = std::map<std::string, std::string>;
  enum class Kind { value, lines };
  void take_over();
  void keep_aside(const std::string& why, const char* ending);

  std::filesystem::path path_;
  Entries entries_, read_;               ///< as they are here, and as they were in the file
  std::map<std::string, Kind> changed_;  ///< since the last save()
  std::vector<std::string> complaints_;
};

/// A file of the user's configuration folder ($XDG_CONFIG_HOME or ~/.config, then pixelscope/NAME).
std::filesystem::path config_file(const std::string& name);

}  // namespace ps::gui
