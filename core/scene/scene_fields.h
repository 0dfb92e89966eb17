#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene_value.h"

namespace ps {

/// The assignments of one block with their keys checked: each is known to the block and is given once, so that
/// no part of a file is ignored. Throws InputError, for an unknown key with the nearest known one.
class SceneFields {
 public:
  /// `block` is "sphere", `place` where the block begins.
  SceneFields(const SceneValues& values, const SceneEntry& block, std::vector<std::string_view> known);

  /// The value of a key, or nullptr.
  const SceneTerm* find(std::string_view key) const;
  /// The value of a key that must be there.
  const SceneTerm& require(std::string_view key) const;
  /// Throws if any of these keys is there; `because` completes "expected no KEY: ...".
  void forbid(const std::vector<std::string_view>& keys, std::string_view because) const;
  const SceneEntry& block() const { return block_; }

 private:
  const SceneValues& values_;
  const SceneEntry& block_;
};

/// Throws the error for an unknown key.
[[noreturn]] void fail_unknown_key(const SceneValues& values, const SceneEntry& entry, std::string_view where,
                                   const std::vector<std::string_view>& known);

/// Two lists of keys, one after the other.
std::vector<std::string_view> joined_keys(std::vector<std::string_view> first,
                                          const std::vector<std::string_view>& second);

}  // namespace ps
