#include "gui/panels/lesson/step_options.h"

#include <algorithm>
#include <vector>

namespace ps::gui {
namespace {

/// Adds the options of the "key=value" lines that `others` lacks, each once.
void add_options(const std::vector<std::string>& lines, const std::vector<std::string>& others,
                 std::vector<const Option*>& options) {
  for (const std::string& line : lines) {
    if (std::find(others.begin(), others.end(), line) != others.end()) continue;
    const Option* option = find_option(line.substr(0, line.find('=')));
    if (option && std::find(options.begin(), options.end(), option) == options.end()) options.push_back(option);
  }
}

/// Calls `use` with every span of the step's text.
template <class Use>
void each_span(const LessonStep& step, Use use) {
  for (const auto* blocks : {&step.blocks, &step.hints})
    for (const TextBlock& block : *blocks)
      for (const TextSpan& span : block.spans) use(span);
}

/// What the settings of a step are about.
std::vector<const Option*> set_options(const LessonState& state) {
  std::vector<const Option*> options;
  add_options(state.set_a, state.set_b, options);
  add_options(state.set_b, state.set_a, options);
  if (options.empty()) add_options(state.set_a, {}, options);
  return options;
}

}  // namespace

std::vector<const Option*> step_options(const LessonStep& step) {
  const bool asks_bug = step.question && step.question->kind == AskKind::bug;
  std::vector<const Option*> options = asks_bug ? std::vector<const Option*>{} : set_options(step.state), placed;
  each_span(step, [&](const TextSpan& span) {
    const Option* option = find_option(span.link.target);
    if (!option || (span.link.kind != LinkKind::option && span.link.kind != LinkKind::control)) return;
    auto& list = span.link.kind == LinkKind::control ? placed : options;
    if (std::find(list.begin(), list.end(), option) == list.end()) list.push_back(option);
  });
  std::erase_if(options,
                [&](const Option* option) { return std::find(placed.begin(), placed.end(), option) != placed.end(); });
  return options;
}

}  // namespace ps::gui
