#include "gui/script/expectation.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "gui/shell/values.h"
#include "gui/widgets/record.h"

namespace ps::gui {
namespace {

std::optional<double> number_in(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

}  // namespace

bool fulfils(const std::string& found, const Expectation& expected) {
  const auto left = number_in(found), right = number_in(expected.value);
  const bool numbers = left && right;
  if (expected.relation == "contains") return found.find(expected.value) != std::string::npos;
  const bool equal = found == expected.value || (numbers && *left == *right);
  if (expected.relation == "=") return equal;
  if (expected.relation == "!=") return !equal;
  if (!numbers) return false;
  if (expected.relation == "<") return *left < *right;
  if (expected.relation == ">") return *left > *right;
  return std::abs(*left - *right) <= expected.tolerance * std::max(1.0, std::abs(*right));
}

std::string similar_controls(const std::string& name) {
  const std::string last = name.substr(name.rfind('/') + 1);
  std::string result;
  int count = 0;
  const auto offer = [&](const std::string& known) {
    if (count >= 6 || known.find(last) == std::string::npos) return;
    result += (count++ == 0 ? "; similar: " : ", ") + known;
  };
  for (const auto& [known, record] : controls().all())
    if (controls().find(known)) offer(known);
  for (const auto& [known, value] : values().published()) offer(known);
  return result;
}

}  // namespace ps::gui
