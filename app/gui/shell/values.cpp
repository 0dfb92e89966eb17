#include "gui/shell/values.h"

#include <fmt/format.h>

#include "gui/widgets/record.h"

namespace ps::gui {

void Values::publish(std::string_view name, std::string value) {
  const auto found = values_.find(name);
  if (found == values_.end())
    values_.emplace(name, std::move(value));
  else
    found->second = std::move(value);
}
void Values::publish(std::string_view name, double value) { publish(name, fmt::format("{}", value)); }
void Values::publish(std::string_view name, std::uint64_t value) { publish(name, std::to_string(value)); }
void Values::publish(std::string_view name, int value) { publish(name, std::to_string(value)); }
void Values::publish(std::string_view name, bool value) { publish(name, std::string(value ? "on" : "off")); }

void Values::withdraw(std::string_view name) {
  const auto found = values_.find(name);
  if (found != values_.end()) values_.erase(found);
}

void Values::offer(std::string_view name, std::function<std::string()> make) {
  offers_[std::string(name)] = std::move(make);
}

std::optional<std::string> Values::find(std::string_view name) const {
  if (const auto offer = offers_.find(name); offer != offers_.end()) return offer->second();
  if (const auto found = values_.find(name); found != values_.end()) return found->second;
  if (const ControlRecord* control = controls().find(name)) return control->value;
  return {};
}

Values& values() {
  static Values the_values;
  return the_values;
}

}  // namespace ps::gui
