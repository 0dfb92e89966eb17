#include "engine/maths.h"

namespace ps {
namespace {

struct RoleOf {
  MathsRole operator()(const MathsSign& sign) const { return sign.role; }
  MathsRole operator()(const MathsGroup& group) const { return of_single(group.inside); }
  MathsRole operator()(const MathsScripts& scripts) const { return of_single(scripts.base); }
  MathsRole operator()(const MathsFraction&) const { return MathsRole::ordinary; }
  MathsRole operator()(const MathsRoot&) const { return MathsRole::ordinary; }
  MathsRole operator()(const MathsAccented&) const { return MathsRole::ordinary; }
  MathsRole operator()(const MathsFence&) const { return MathsRole::ordinary; }
  MathsRole operator()(const MathsMatrix&) const { return MathsRole::ordinary; }
  MathsRole operator()(const MathsWords&) const { return MathsRole::ordinary; }
  MathsRole operator()(const MathsSpace&) const { return MathsRole::ordinary; }

  static MathsRole of_single(const MathsRow& row) {
    return row.size() == 1 ? std::visit(RoleOf{}, row.front().what) : MathsRole::ordinary;
  }
};

bool wants_operand(MathsRole role) {
  switch (role) {
  case MathsRole::ordinary:
  case MathsRole::closing:
    return false;
  case MathsRole::function:
  case MathsRole::binary:
  case MathsRole::relation:
  case MathsRole::opening:
  case MathsRole::punctuation:
    return true;
  }
  return false;
}

constexpr double thin = 3.0 / 18, medium = 4.0 / 18, thick = 5.0 / 18;

}  // namespace

std::vector<MathsRole> roles_in(const MathsRow& row) {
  std::vector<MathsRole> roles;
  bool operand_before = false;
  for (const MathsNode& node : row) {
    MathsRole role = std::visit(RoleOf{}, node.what);
    if (role == MathsRole::binary && !operand_before) role = MathsRole::ordinary;
    roles.push_back(role);
    if (!std::holds_alternative<MathsSpace>(node.what)) operand_before = !wants_operand(role);
  }
  // A sign at the end, as in "x^+", does not bind either.
  if (!roles.empty() && roles.back() == MathsRole::binary) roles.back() = MathsRole::ordinary;
  return roles;
}

double maths_space(MathsRole left, MathsRole right, bool in_script) {
  const auto is = [](MathsRole role, MathsRole wanted) { return role == wanted; };
  const bool relation = is(left, MathsRole::relation) || is(right, MathsRole::relation);
  const bool binary = is(left, MathsRole::binary) || is(right, MathsRole::binary);
  if (relation) {
    const bool both = is(left, MathsRole::relation) && is(right, MathsRole::relation);
    const bool at_edge =
        is(left, MathsRole::opening) || is(right, MathsRole::closing) || is(right, MathsRole::punctuation);
    return both || at_edge || in_script ? 0 : thick;
  }
  if (binary) return in_script ? 0 : medium;
  if (is(left, MathsRole::punctuation)) return in_script ? 0 : thin;
  if (is(left, MathsRole::function)) return is(right, MathsRole::ordinary) || is(right, MathsRole::function) ? thin : 0;
  if (is(right, MathsRole::function)) return is(left, MathsRole::ordinary) || is(left, MathsRole::closing) ? thin : 0;
  return 0;
}

}  // namespace ps
