#include "engine/claim.h"

#include <fmt/format.h>

#include "document/number_list.h"
#include "engine/block.h"
#include "options/option.h"

namespace ps {
namespace {

/// What stands behind `mutation`: the key of an option, `metric ...`, or a line of a `settings` block.
void read_mutation(const BlockLine& line, const Claim& claim, Mutation& mutation) {
  const auto space = line.rest.find(' ');
  BlockLine change{line.rest.substr(0, space), {}, line.place};
  std::string text = line.rest;
  if (space == std::string::npos) {
    if (!find_option(line.rest))
      throw InputError(fmt::format("mutation: '{}' is not an option, nor a line of a settings block", line.rest));
    mutation.reset.push_back(line.rest);
    text = "default " + line.rest;
  } else {
    change.rest = line.rest.substr(line.rest.find_first_not_of(' ', space));
    if (change.word == "metric") {
      mutation.metric = parse_metric(change.rest);
      mutation.metric.within = claim.metric.within;
      mutation.changes_metric = true;
    } else if (!read_state_line(change, mutation.state)) {
      throw InputError(fmt::format(
          "mutation: found '{}', expected an option, 'metric ...' or a line of a settings block", line.rest));
    }
  }
  mutation.text += (mutation.text.empty() ? "" : "; ") + text;
}

void read_claim_line(const BlockLine& line, Claim& claim, std::vector<BlockLine>& mutations) {
  if (line.word == "text") {
    claim.text = line.rest;
  } else if (line.word == "metric") {
    const auto within = claim.metric.within;
    claim.metric = parse_metric(line.rest);
    claim.metric.within = within;
  } else if (line.word == "within") {
    claim.metric.within = parse_region_text(line.rest);
  } else if (line.word == "bound") {
    claim.bound = parse_bound(line.rest);
  } else if (line.word == "mutation") {
    mutations.push_back(line);
  } else if (read_state_line(line, claim.state)) {
    read_state_line(line, claim.own);
  } else {
    throw InputError(fmt::format("unknown word '{}' in a claim", line.word));
  }
}

bool has_line(const std::vector<BlockLine>& lines, std::string_view word) {
  for (const BlockLine& line : lines)
    if (line.word == word) return true;
  return false;
}

}  // namespace

void require_within(const Metric& metric) {
  if (metric.within && !reads_pictures(metric.kind))
    throw InputError(fmt::format("within: '{}' is not measured on a part of the pictures", metric_text(metric)));
}

Claim read_claim(const std::vector<BlockLine>& lines, const LessonState& start, const SourcePlace& place) {
  Claim claim;
  claim.state = start;
  claim.place = place;
  std::vector<BlockLine> mutations;
  for (const BlockLine& line : lines) at_place(line.place, [&] { read_claim_line(line, claim, mutations); });
  if (claim.text.empty() || !has_line(lines, "metric") || !has_line(lines, "bound") || mutations.empty())
    throw InputError(place, "a claim that lacks a line", "text, metric, bound and mutation");
  at_place(place, [&] { require_within(claim.metric); });
  claim.mutation.state = claim.state;
  claim.mutation.metric = claim.metric;
  for (const BlockLine& line : mutations)
    at_place(line.place, [&] {
      read_mutation(line, claim, claim.mutation);
      require_within(claim.mutation.metric);
    });
  return claim;
}

}  // namespace ps
