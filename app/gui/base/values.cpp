#include "gui/base/values.h"

#include <fmt/format.h>

#include "gui/base/record.h"

namespace ps::gui {

std::string script_text(double value) { return fmt::format("{}", value); }
std::string script_text(int value) { return std::to_string(value); }
std::string script_text(std::uint64_t value) { return std::to_string(value); }
std::string script_text(bool value) { return value ? "on" : "off"; }

void Values::withdraw(std::string_view name) {
  const auto found = values_.find(name);
  if (found != values_.end()) values_.erase(found);
}

void Values::offer_below(std::string_view prefix,
                         std::function<std::optional<std::string>(std::string_view rest)> find) {
  below_.insert_or_assign(std::string(prefix), std::move(find));
}

std::optional<std::string> Values::find(std::string_view name) const {
  if (const auto offer = offers_.find(name); offer != offers_.end()) return offer->second();
  if (const auto found = values_.find(name); found != values_.end()) return found->second;
  for (const auto& [prefix, find] : below_)
    if (name.starts_with(prefix))
      if (auto value = find(name.substr(prefix.size()))) return value;
  if (const ControlRecord* control = controls().find(name)) return control->value;
  return {};
}

std::vector<std::string> Values::names() const {
  std::vector<std::string> all;
  for (const auto& [name, value] : values_) all.push_back(name);
  for (const auto& [name, make] : offers_) all.push_back(name);
  return all;
}

Values& values() {
  static Values the_values;
  return the_values;
}

}  // namespace ps::gui
