#include "engine/claim.h"

#include <fmt/format.h>

#include <array>

#include "base/number_text.h"
#include "engine/block.h"
#include "options/option.h"

namespace ps {
namespace {

constexpr std::array<std::string_view, 16> metric_keys{"differing-pixels",
                                                       "mean-difference",
                                                       "max-difference",
                                                       "counter-a",
                                                       "counter-b",
                                                       "false-shadow-pixels",
                                                       "red-a",
                                                       "green-a",
                                                       "blue-a",
                                                       "red-b",
                                                       "green-b",
                                                       "blue-b",
                                                       "object-a",
                                                       "object-b",
                                                       "triangle-a",
                                                       "triangle-b"};

Counter parse_counter(std::string_view key) {
  for (std::size_t i = 0; i < counter_count; ++i)
    if (counter_key(static_cast<Counter>(i)) == key) return static_cast<Counter>(i);
  throw InputError(fmt::format("'{}' is not a counter", key));
}

bool counts(ClaimMetric metric) { return metric == ClaimMetric::counter_a || metric == ClaimMetric::counter_b; }

void read_metric(const std::string& rest, Claim& claim) {
  const auto space = rest.find(' ');
  claim.metric = parse_metric(rest.substr(0, space));
  const std::string argument = space == std::string::npos ? "" : rest.substr(space + 1);
  if (counts(claim.metric))
    claim.counter = parse_counter(argument);
  else if (!argument.empty())
    throw InputError(fmt::format("found '{}' after the metric, expected nothing", argument));
}

/// ">= 1000"
void read_bound(const std::string& rest, Claim& claim) {
  const auto space = rest.find(' ');
  const std::string sign = rest.substr(0, space);
  const auto number = space == std::string::npos ? std::nullopt : parse_number(rest.substr(space + 1));
  if (!number) throw InputError(fmt::format("found '{}', expected >=, <= or = and a number", rest));
  claim.number = *number;
  for (const ClaimBound bound : {ClaimBound::at_least, ClaimBound::at_most, ClaimBound::equals})
    if (bound_text(bound) == sign) {
      claim.bound = bound;
      return;
    }
  throw InputError(fmt::format("found '{}', expected >=, <= or =", sign));
}

void read_claim_line(const BlockLine& line, Claim& claim) {
  if (line.word == "text") {
    claim.text = line.rest;
  } else if (line.word == "metric") {
    read_metric(line.rest, claim);
  } else if (line.word == "bound") {
    read_bound(line.rest, claim);
  } else if (line.word == "mutation") {
    if (!find_option(line.rest)) throw InputError(fmt::format("mutation: '{}' is not an option", line.rest));
    claim.mutation = line.rest;
  } else if (!read_state_line(line, claim.state)) {
    throw InputError(fmt::format("unknown word '{}' in a claim", line.word));
  }
}

}  // namespace

std::string_view metric_key(ClaimMetric metric) { return metric_keys.at(static_cast<std::size_t>(metric)); }

ClaimMetric parse_metric(std::string_view key) {
  for (std::size_t i = 0; i < metric_keys.size(); ++i)
    if (metric_keys[i] == key) return static_cast<ClaimMetric>(i);
  throw InputError(fmt::format("'{}' is not a metric, expected one of {}", key, fmt::join(metric_keys, " ")));
}

std::string_view bound_text(ClaimBound bound) {
  switch (bound) {
  case ClaimBound::at_least:
    return ">=";
  case ClaimBound::at_most:
    return "<=";
  case ClaimBound::equals:
    return "=";
  }
  return "";
}

Claim read_claim(const std::vector<BlockLine>& lines, const LessonState& start, const SourcePlace& place) {
  Claim claim;
  claim.state = start;
  claim.place = place;
  bool metric = false, bound = false;
  for (const BlockLine& line : lines) {
    at_place(line.place, [&] { read_claim_line(line, claim); });
    metric = metric || line.word == "metric";
    bound = bound || line.word == "bound";
  }
  if (claim.text.empty() || !metric || !bound || claim.mutation.empty())
    throw InputError(place, "a claim that lacks a line", "text, metric, bound and mutation");
  return claim;
}

bool keeps_bound(const Claim& claim, double value) {
  switch (claim.bound) {
  case ClaimBound::at_least:
    return value >= claim.number;
  case ClaimBound::at_most:
    return value <= claim.number;
  case ClaimBound::equals:
    return value == claim.number;
  }
  return false;
}

}  // namespace ps
