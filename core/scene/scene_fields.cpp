#include "scene/scene_fields.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/spelling.h"

namespace ps {

void fail_unknown_key(const SceneValues& values, const SceneEntry& entry, std::string_view where,
                      const std::vector<std::string_view>& known) {
  const std::string found =
      entry.key.empty() ? entry.value.shown() : fmt::format("unknown key '{}' in {}", entry.key.substr(0, 60), where);
  const std::string expected = entry.key.empty() ? "KEY = VALUE" : expected_word(entry.key, known);
  values.fail_at(entry.line, entry.column, found, expected);
}

SceneFields::SceneFields(const SceneValues& values, const SceneEntry& block, std::vector<std::string_view> known)
    : values_(values), block_(block) {
  if (block.value.kind != SceneTerm::Kind::block) values.fail(block.value, fmt::format("'{{' after '{}'", block.key));
  const auto& entries = block.value.entries;
  for (auto entry = entries.begin(); entry != entries.end(); ++entry) {
    if (std::find(known.begin(), known.end(), entry->key) == known.end())
      fail_unknown_key(values, *entry, block.key, known);
    const auto first = std::find_if(entries.begin(), entry, [&](const SceneEntry& e) { return e.key == entry->key; });
    if (first != entry)
      values.fail_at(entry->line, entry->column, fmt::format("a second '{}'", entry->key),
                     fmt::format("the one in line {} only", first->line));
  }
}

const SceneTerm* SceneFields::find(std::string_view key) const {
  const auto& entries = block_.value.entries;
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const SceneEntry& e) { return e.key == key; });
  return found == entries.end() ? nullptr : &found->value;
}

const SceneTerm& SceneFields::require(std::string_view key) const {
  if (const SceneTerm* term = find(key)) return *term;
  values_.fail_at(block_.line, block_.column, fmt::format("{} without '{}'", block_.key, key),
                  fmt::format("'{} = ...' in it", key));
}

void SceneFields::forbid(const std::vector<std::string_view>& keys, std::string_view because) const {
  for (const SceneEntry& entry : block_.value.entries)
    if (std::find(keys.begin(), keys.end(), entry.key) != keys.end())
      values_.fail_at(entry.line, entry.column, fmt::format("'{}'", entry.key), std::string(because));
}

std::vector<std::string_view> joined_keys(std::vector<std::string_view> first,
                                          const std::vector<std::string_view>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

}  // namespace ps
