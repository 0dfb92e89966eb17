#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace ps::gui {

/// Values that the window makes known to scripts: `expect story/verdict "..."`. Names are stable paths. What controls
/// show is known by the control's name without publishing it. Main thread only.
class Values {
 public:
  void publish(std::string_view name, std::string value);
  void publish(std::string_view name, double value);  ///< shortest text that reads back exactly
  void publish(std::string_view name, std::uint64_t value);
  void publish(std::string_view name, int value);
  void publish(std::string_view name, bool value);  ///< "on" or "off"
  void publish(std::string_view name, const char* value) { publish(name, std::string(value)); }
  void publish(std::string_view name, std::string_view value) { publish(name, std::string(value)); }
  void withdraw(std::string_view name);
  /// A value that is made when it is asked for.
  void offer(std::string_view name, std::function<std::string()> make);

  /// A published value, or the value that the control of this name showed in the last frame.
  std::optional<std::string> find(std::string_view name) const;
  const std::map<std::string, std::string, std::less<>>& published() const { return values_; }

 private:
  std::map<std::string, std::string, std::less<>> values_;
  std::map<std::string, std::function<std::string()>, std::less<>> offers_;
};

/// The one registry.
Values& values();

}  // namespace ps::gui
