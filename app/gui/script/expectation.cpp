#include "gui/script/expectation.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "base/number_text.h"
#include "base/spelling.h"
#include "gui/base/record.h"
#include "gui/base/values.h"

namespace ps::gui {
bool fulfils(const std::string& found, const Expectation& expected) {
  const auto left = parse_number(found), right = parse_number(expected.value);
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

std::string similar_controls(const std::string& name, Named wanted) {
  constexpr std::size_t most = 6;
  std::vector<std::string> known;
  for (const auto& [control, record] : controls().all())
    if (controls().find(control)) known.push_back(control);
  std::string result;
  if (wanted == Named::any)
    for (std::string& value : values().names()) known.push_back(std::move(value));
  else if (values().find(name))
    result = "; it is a value, which can be read and not clicked";
  // Those with the same last word, else those of the same panel, the nearest first.
  const std::string last = name.substr(name.rfind('/') + 1), panel = name.substr(0, name.find('/') + 1);
  std::vector<std::string> similar;
  for (const std::string& each : known)
    if (each.find(last) != std::string::npos) similar.push_back(each);
  if (similar.empty() && !panel.empty())
    for (const std::string& each : known)
      if (each.starts_with(panel)) similar.push_back(each);
  std::stable_sort(similar.begin(), similar.end(), [&](const std::string& a, const std::string& b) {
    return edit_distance(a, name) < edit_distance(b, name);
  });
  for (std::size_t i = 0; i < std::min(most, similar.size()); ++i)
    result += (i == 0 ? "; similar: " : ", ") + similar[i];
  return result;
}

}  // namespace ps::gui
