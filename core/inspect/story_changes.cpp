#include "inspect/story_changes.h"

#include <algorithm>
#include <tuple>

#include "inspect/describe.h"
#include "inspect/parting/align_stories.h"

namespace ps {
namespace {

/// The fields of both events by name, in the later one's order; those that are gone come last.
std::vector<FieldChange> field_changes(const std::vector<FieldText>& before, const std::vector<FieldText>& after) {
  std::vector<FieldChange> changes;
  const auto named = [](const std::vector<FieldText>& fields, const std::string& name) {
    return std::find_if(fields.begin(), fields.end(), [&](const FieldText& field) { return field.name == name; });
  };
  for (const FieldText& field : after) {
    FieldChange change{field.name, {}, field.value, {}, field.exact, true};
    if (const auto old = named(before, field.name); old != before.end()) {
      change.before = old->value;
      change.exact_before = old->exact;
      change.changed = old->exact != field.exact;
    }
    changes.push_back(std::move(change));
  }
  for (const FieldText& field : before)
    if (named(after, field.name) == after.end())
      changes.push_back({field.name, field.value, {}, field.exact, {}, true});
  return changes;
}

const Event* event_at(const PixelStory& story, int index) {
  return index < 0 ? nullptr : &story.events[static_cast<std::size_t>(index)];
}

StepChange step_change(const PixelStory& before, const PixelStory& after, const AlignedRow& row, const Scene& scene) {
  const Event *old = event_at(before, row.a), *now = event_at(after, row.b);
  StepChange step{row.a, row.b, row.depth, false, describe(now ? *now : *old, scene), {}};
  step.fields = field_changes(old ? event_table(*old, scene) : std::vector<FieldText>{},
                              now ? event_table(*now, scene) : std::vector<FieldText>{});
  step.changed = !old || !now ||
                 std::any_of(step.fields.begin(), step.fields.end(), [](const FieldChange& f) { return f.changed; });
  return step;
}

/// Lines are the same where their events are partners and their levels and kinds are equal.
using LineKey = std::tuple<int, int, LedgerTerm>;

LineKey key_of(const LedgerLine& line, int partner) { return {line.level, partner, line.kind}; }

std::vector<LedgerChange> ledger_changes(const PixelStory& before, const PixelStory& after,
                                         const std::vector<AlignedRow>& rows) {
  std::vector<int> partner(before.events.size(), -2);  // of each old event, among the new ones
  for (const AlignedRow& row : rows)
    if (row.a >= 0 && row.b >= 0) partner[static_cast<std::size_t>(row.a)] = row.b;
  std::vector<LineKey> old_keys;
  for (const LedgerLine& line : before.ledger)
    old_keys.push_back(key_of(line, line.event < 0 ? -1 : partner[static_cast<std::size_t>(line.event)]));
  std::vector<bool> used(before.ledger.size(), false);
  std::vector<LedgerChange> changes;
  std::size_t placed = 0;  // old lines before this have their place
  const auto add_gone = [&](std::size_t end) {
    for (; placed < end; ++placed)
      if (!used[placed])
        changes.push_back(
            {before.ledger[placed].level, before.ledger[placed].term, before.ledger[placed].value, {}, -1});
  };
  for (const LedgerLine& line : after.ledger) {
    LedgerChange change{line.level, line.term, {}, line.value, line.event};
    const LineKey key = key_of(line, line.event);
    for (std::size_t i = placed; i < old_keys.size(); ++i)
      if (!used[i] && old_keys[i] == key) {
        used[i] = true;
        add_gone(i);
        placed = i + 1;
        change.before = before.ledger[i].value;
        break;
      }
    changes.push_back(std::move(change));
  }
  add_gone(before.ledger.size());
  return changes;
}

}  // namespace

StoryChanges story_changes(const PixelStory& before, const PixelStory& after, const Scene& scene) {
  const std::vector<AlignedRow> rows = align_stories(before, after, scene);
  StoryChanges changes;
  for (const AlignedRow& row : rows) {
    changes.steps.push_back(step_change(before, after, row, scene));
    changes.changed_steps += changes.steps.back().changed ? 1 : 0;
  }
  changes.ledger = ledger_changes(before, after, rows);
  changes.linear_before = before.linear;
  changes.linear_after = after.linear;
  changes.display_before = before.display;
  changes.display_after = after.display;
  return changes;
}

}  // namespace ps
