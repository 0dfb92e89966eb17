#include "gui/panels/options/row_results.h"

#include <fmt/format.h>

namespace ps::gui {
namespace {

/// The settings that wake a grey row, as one step.
void wake_row(Session& session, Side side, const Option& option, const Waking& waking) {
  Settings settings = session.settings(side);
  wake(waking, settings);
  std::string set;
  for (const OptionValue& each : waking.settings)
    set += fmt::format("{}{} = {}", set.empty() ? "" : ", ", each.option->key, option_text(*each.option, settings));
  session.set_settings(side, settings, fmt::format("{}: {}, for {}", letter_of(side), set, option.key));
}

}  // namespace

void take_row_result(Session& session, Side side, const Option& option, const Settings& settings,
                     const OptionRowResult& result) {
  const Side other = other_side(side);
  if (result.edit.changed)
    session.set_settings(side, settings,
                         fmt::format("{}: {} = {}", letter_of(side), option.key, option_text(option, settings)),
                         fmt::format("{}/{}", letter_of(side), option.key));
  if (result.edit.finished) session.end_drag();
  switch (result.request) {
  case OptionRequest::none:
  case OptionRequest::sweep:
    return;
  case OptionRequest::send_to_other: {
    Settings changed = session.settings(other);
    option.set(changed, option.get(session.settings(side)));
    return session.set_settings(other, changed, fmt::format("copy {}", option.label));
  }
  case OptionRequest::only_difference: {
    Settings changed = session.settings(side);
    option.set(changed, option.get(session.settings(other)));
    return session.set_settings(other, changed, fmt::format("differ in {} only", option.label));
  }
  case OptionRequest::wake:
    return wake_row(session, side, option, result.waking);
  }
}

}  // namespace ps::gui
