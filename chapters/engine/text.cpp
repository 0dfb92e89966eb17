#include "engine/text.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/check.h"
#include "base/spelling.h"
#include "engine/glossary.h"
#include "engine/lesson_place.h"
#include "engine/screen_names.h"
#include "engine/words.h"
#include "options/option.h"

namespace ps {
namespace {

std::vector<std::string_view> linked_panels() {
  std::vector<std::string_view> names(tool_names::all.begin(), tool_names::all.end());
  names.insert(names.end(), {options_panel_name, story_names::one, story_names::parting});
  return names;
}

const Option& option_of_text(std::string_view key) {
  if (const Option* option = find_option(key)) return *option;
  std::vector<std::string_view> keys;
  for (const Option& option : option_table()) keys.push_back(option.key);
  throw InputError(fmt::format("unknown option '{}'{}", key, did_you_mean(std::string(key), keys, "")));
}

}  // namespace

std::string plain_text(const TextBlock& block) {
  std::string text;
  for (const TextSpan& span : block.spans) text += span.text;
  return text;
}

const Formula* display_formula(const TextBlock& block) {
  if (block.spans.size() != 1 || !block.spans.front().formula) return nullptr;
  const Formula& formula = *block.spans.front().formula;
  return formula.form == FormulaForm::display ? &formula : nullptr;
}

TextLink parse_link(std::string_view target) {
  const auto colon = target.find(':');
  const std::string_view kind = target.substr(0, colon);
  const std::string_view name = colon == std::string_view::npos ? std::string_view{} : target.substr(colon + 1);
  if (kind == "option") return {LinkKind::option, std::string(option_of_text(name).key), 0, {}};
  if (kind == "step") return {LinkKind::step, {}, parse_step_number(name), {}};
  if (kind == "lesson") {
    const LessonPlace place = parse_built_in_place(name);
    return {LinkKind::lesson, place.lesson, place.step, {}};
  }
  if (kind == "term") {
    if (std::string term = term_of(name); !term.empty()) return {LinkKind::term, std::move(term), 0, {}};
    throw InputError(fmt::format("unknown term '{}'{}", name, did_you_mean(name, glossary_terms(), "")));
  }
  if (kind == "panel") {
    const auto panels = linked_panels();
    if (std::find(panels.begin(), panels.end(), name) == panels.end())
      throw InputError(fmt::format("unknown panel '{}'{}", name, did_you_mean(std::string(name), panels, "")));
    return {LinkKind::panel, std::string(name), 0, {}};
  }
  throw InputError(fmt::format(
      "found the link '{}', expected option:KEY, panel:NAME, step:N, lesson:FOLDER/N or term:TERM", target));
}

TextLink parse_control(std::string_view target) {
  TextLink link{LinkKind::control, {}, 0, {}};
  if (target.substr(0, 2) == "a.") link.side = Side::a;
  if (target.substr(0, 2) == "b.") link.side = Side::b;
  link.target = option_of_text(link.side ? target.substr(2) : target).key;
  return link;
}

TextLink link_of_name(std::string_view name) {
  const std::string wanted = in_lower_case(name);
  for (const Option& option : option_table())
    if (in_lower_case(option.label) == wanted || option.key == wanted)
      return {LinkKind::option, std::string(option.key), 0, {}};
  for (const Option& option : option_table())
    if (in_lower_case(option.group) == wanted) return {LinkKind::option, std::string(option.key), 0, {}};
  if (wanted == "pixel") return {LinkKind::panel, std::string(story_names::one), 0, {}};
  const auto panels = linked_panels();
  if (std::find(panels.begin(), panels.end(), wanted) != panels.end()) return {LinkKind::panel, wanted, 0, {}};
  return {};
}

}  // namespace ps
