#include "study/stability/series.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "base/check.h"
#include "base/enumerators.h"
#include "study/stability/experiment.h"

namespace ps {
namespace {

/// Does the text match, with '*' for any text?
bool matches(std::string_view pattern, std::string_view text) {
  const auto star = pattern.find('*');
  if (star == std::string_view::npos) return pattern == text;
  if (text.substr(0, star) != pattern.substr(0, star)) return false;
  const std::string_view rest = pattern.substr(star + 1);
  for (std::size_t from = star; from <= text.size(); ++from)
    if (matches(rest, text.substr(from))) return true;
  return false;
}

struct Match {
  const StabilitySeries* quantity = nullptr;
  int alternative = 0;  ///< counted through all declarations
  std::size_t letters = 0;
};

std::optional<Match> best_match(const StabilityExperiment& experiment, std::string_view series) {
  std::optional<Match> best;
  int alternative = 0;
  for (const StabilitySeries& quantity : experiment.series) {
    std::string_view rest = quantity.names;
    while (true) {
      const auto bar = rest.find('|');
      const std::string_view pattern = rest.substr(0, bar);
      const auto letters = pattern.size() - static_cast<std::size_t>(std::count(pattern.begin(), pattern.end(), '*'));
      if (matches(pattern, series) && (!best || letters > best->letters)) best = {&quantity, alternative, letters};
      ++alternative;
      if (bar == std::string_view::npos) break;
      rest.remove_prefix(bar + 1);
    }
  }
  return best;
}

Match match_of(const StabilityExperiment& experiment, std::string_view series) {
  const auto match = best_match(experiment, series);
  if (!match)
    throw InputError(
        fmt::format("experiment {}: found the series '{}', which it does not declare", experiment.key, series));
  return *match;
}

}  // namespace

std::string_view better_text(Better better) {
  switch (better) {
  case Better::lower:
    return "lower is better";
  case Better::higher:
    return "higher is better";
  case Better::neither:
    return "";
  }
  return "";
}

std::string_view better_key(Better better) { return enumerator_key(better); }

const StabilitySeries& quantity_of(const StabilityExperiment& experiment, std::string_view series) {
  return *match_of(experiment, series).quantity;
}

int series_order(const StabilityExperiment& experiment, std::string_view series) {
  return match_of(experiment, series).alternative;
}

std::string_view case_name(const StabilitySeries& quantity, double knob) {
  const auto found =
      std::find_if(quantity.cases.begin(), quantity.cases.end(), [&](const KnobCase& one) { return one.knob == knob; });
  return found == quantity.cases.end() ? std::string_view{} : found->name;
}

}  // namespace ps
