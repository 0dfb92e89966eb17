#include "gui/panels/lesson/glossary_sheet.h"

#include <vector>

#include "base/check.h"
#include "base/word_search.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr int frames_to_scroll = 3;  // the list has its full length only once it was drawn

/// What the file holds, or what is wrong with it.
struct ReadGlossary {
  const std::vector<GlossaryEntry>* entries = nullptr;
  std::string fault;
};

const ReadGlossary& read_once() {
  static const ReadGlossary result = [] {
    ReadGlossary read;
    try {
      read.entries = &glossary();
    } catch (const InputError& error) {
      read.fault = error.what();
    }
    return read;
  }();
  return result;
}

std::string all_forms(const GlossaryEntry& entry) {
  std::string forms;
  for (const std::string& form : entry.forms) forms += form + " ";
  return forms;
}

}  // namespace

/// The term in bold on a line of its own, its definition below.
std::optional<LinkTarget> GlossarySheet::draw_entry(const GlossaryEntry& entry, float width) {
  const bool marked = entry.term == term_;
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float edge = px(8), inside = width - 2 * edge;
  std::vector<TextLine> lines;
  lay_out(entry.definition, {}, Face::body, inside, lines);
  float height = ImGui::GetTextLineHeight() + px(8);
  for (const TextLine& line : lines) height += line.gap + line.height;
  const ImVec2 to{from.x + width, from.y + height};
  if (marked) ImGui::GetWindowDrawList()->AddRectFilled(from, to, colour_u32(palette().selection), px(4));
  ImGui::SetCursorScreenPos({from.x + edge, from.y + px(4)});
  {
    const FontScope bold(Face::bold);
    draw_lines(ImGui::GetCursorScreenPos(), entry.term, palette().text);
  }
  ImGui::SetCursorScreenPos({from.x + edge, from.y + px(4) + ImGui::GetTextLineHeight()});
  auto followed = draw_text_lines(session_, lines, inside);
  ImGui::SetCursorScreenPos(from);
  ImGui::Dummy({width, height + px(6)});
  if (marked && scroll_for_ > 0) {
    ImGui::SetScrollHereY(0.3f);
    --scroll_for_;
  }
  controls().record("term/" + entry.term, from, {to.x, from.y + px(4) + ImGui::GetTextLineHeight()},
                    plain_text(entry.definition));
  return followed;
}

void GlossarySheet::show(const std::string& term) {
  open();
  search_.clear();
  term_ = term;
  scroll_for_ = frames_to_scroll;
}

void GlossarySheet::add_actions(Actions& actions) {
  ActionGroup(actions, "Lesson").add("glossary", "Glossary: terms and what they mean", "Shift+G", [this] { show({}); });
}

void GlossarySheet::take(const PanelMessage& message) {
  const auto* target = std::get_if<LinkTarget>(&message);
  if (target && target->link.kind == LinkKind::term) show(target->link.target);
}

void GlossarySheet::draw_sheet() {
  search_box("search", search_, "Search terms and definitions");
  ImGui::Dummy({0, px(4)});
  std::optional<LinkTarget> followed;
  ImGui::BeginChild("##terms");
  const ReadGlossary& read = read_once();
  if (!read.entries) quiet_text(read.fault);
  const float width = ImGui::GetContentRegionAvail().x;
  std::size_t shown = 0;
  if (read.entries)
    for (const GlossaryEntry& entry : *read.entries) {
      if (!has_words(search_, {entry.term, all_forms(entry), plain_text(entry.definition)})) continue;
      ++shown;
      if (auto clicked = draw_entry(entry, width)) followed = std::move(clicked);
    }
  if (read.entries && shown == 0) quiet_text("No term or definition has these words.");
  ImGui::EndChild();
  if (!followed) return;
  if (followed->link.kind != LinkKind::term) open_ = false;
  host_.send(*followed);
}

}  // namespace ps::gui
