#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ps::gui {

/// A value as scripts read it. Numbers are the shortest text that reads back exactly; truth is "on" or "off".
inline std::string script_text(std::string text) { return text; }
inline std::string script_text(std::string_view text) { return std::string(text); }
inline std::string script_text(const char* text) { return text; }
std::string script_text(double value);
std::string script_text(int value);
std::string script_text(std::uint64_t value);
std::string script_text(bool value);

/// Values that the window makes known to scripts: `expect story/verdict "..."`. Names are stable paths. What controls
/// show is known by the control's name without publishing it. Main thread only.
///
/// What is offered is made when a script asks for it, so that it costs a frame nothing. Whatever an offer reads must
/// outlive the last script step.
class Values {
 public:
  /// A value that is noted now. For what only the moment of its making knows.
  template <class Value>
  void publish(std::string_view name, Value&& value) {
    values_.insert_or_assign(std::string(name), script_text(std::forward<Value>(value)));
  }
  void withdraw(std::string_view name);
  /// A value that is made when it is asked for, by a function without parameters.
  template <class Make>
  void offer(std::string_view name, Make make) {
    offers_.insert_or_assign(std::string(name), [make = std::move(make)] { return script_text(make()); });
  }
  /// All values whose names begin with `prefix`: `find` gets the rest of the name, and answers nothing for one that
  /// does not exist.
  void offer_below(std::string_view prefix, std::function<std::optional<std::string>(std::string_view rest)> find);

  /// A published or offered value, or the value that the control of this name showed in the last frame.
  std::optional<std::string> find(std::string_view name) const;
  /// The names of all published and offered values, but for those offered below a prefix.
  std::vector<std::string> names() const;

 private:
  std::map<std::string, std::string, std::less<>> values_;
  std::map<std::string, std::function<std::string()>, std::less<>> offers_;
  std::map<std::string, std::function<std::optional<std::string>(std::string_view)>, std::less<>> below_;
};

/// The one registry.
Values& values();

}  // namespace ps::gui
