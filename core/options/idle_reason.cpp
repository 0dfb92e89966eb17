#include "options/idle_reason.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/check.h"
#include "options/option.h"

namespace ps {
namespace {

std::string value_text(const Need& need) {
  const Option* option = find_option(need.option);
  PS_ASSERT(option, "a reason names an option of the table");
  Settings settings;
  option->set(settings, need.value);
  return option_text(*option, settings);
}

}  // namespace

IdleReason::IdleReason(std::initializer_list<Need> needs) : kind_(Kind::setting), count_(needs.size()) {
  PS_ASSERT(needs.size() <= needs_.size(), "few needs");
  std::copy(needs.begin(), needs.end(), needs_.begin());
}

IdleReason IdleReason::because(std::string_view why) const {
  IdleReason reason = *this;
  reason.why_ = why;
  return reason;
}

IdleReason IdleReason::said(std::string_view words) const {
  IdleReason reason = *this;
  reason.words_ = words;
  return reason;
}

std::string IdleReason::text() const {
  if (!words_.empty()) return std::string(words_);
  std::string text;
  for (const Need& need : needs())
    text += text.empty() ? fmt::format("needs {} = {}", need.option, value_text(need)) : " or " + value_text(need);
  return why_.empty() ? text : fmt::format("{}: {}", text, why_);
}

}  // namespace ps
