#include "engine/claim.h"

#include <fmt/format.h>

#include "engine/block.h"
#include "engine/words.h"
#include "options/option.h"

namespace ps {
namespace {

/// Reads the words behind `mutation`: the key of an option, `metric ...`, or a line of a `settings` block.
void read_mutation(const BlockLine& line, Mutation& mutation) {
  std::string_view rest = line.rest;
  const std::string word(take_word(rest));
  std::string text = line.rest, words = line.rest;
  if (rest.empty()) {
    const Option* option = find_option(word);
    if (!option) throw InputError(fmt::format("mutation: '{}' is not an option, nor a line of a settings block", word));
    mutation.reset.push_back(word);
    text = "default " + word;
    words = fmt::format("{} at its default", option->label);
  } else {
    const BlockLine change{word, std::string(rest), line.place};
    if (word == "metric") {
      read_metric_line(change, mutation.metric);
      mutation.changes_metric = true;
    } else if (!read_state_line(change, mutation.state)) {
      throw InputError(fmt::format(
          "mutation: found '{}', expected an option, 'metric ...' or a line of a settings block", line.rest));
    }
  }
  const std::string_view joint = mutation.text.empty() ? "" : "; ";
  mutation.text.append(joint).append(text);
  mutation.words.append(joint).append(words);
}

void read_claim_line(const BlockLine& line, Claim& claim, std::vector<BlockLine>& mutations) {
  if (read_metric_line(line, claim.metric)) return;
  if (line.word == "text") {
    claim.text = line.rest;
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

}  // namespace

Claim read_claim(const std::vector<BlockLine>& lines, const LessonState& start, const SourcePlace& place) {
  Claim claim;
  claim.state = start;
  std::vector<BlockLine> mutations;
  for (const BlockLine& line : lines) at_place(line.place, [&] { read_claim_line(line, claim, mutations); });
  if (claim.text.empty() || !has_line(lines, "metric") || !has_line(lines, "bound") || mutations.empty())
    throw InputError(place, "a claim that lacks a line", "text, metric, bound and mutation");
  at_place(place, [&] { require_within(claim.metric); });
  claim.mutation.state = claim.state;
  claim.mutation.metric = claim.metric;
  for (const BlockLine& line : mutations)
    at_place(line.place, [&] {
      read_mutation(line, claim.mutation);
      require_within(claim.mutation.metric);
    });
  return claim;
}

}  // namespace ps
