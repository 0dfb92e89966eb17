#include "gui/panels/lesson/text_view.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "base/check.h"
#include "engine/glossary.h"
#include "gui/base/fit.h"
#include "gui/panels/lesson/option_field.h"
#include "gui/panels/lesson/text_needs.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/maths_draw.h"
#include "gui/widgets/screen_painter.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

/// Buttons and menus as the lessons name them.
struct NamedControl {
  std::string_view word, control;
};
constexpr std::array named_controls{
    NamedControl{"Measure", "chart/measure"}, NamedControl{"Find out", "needs/measure"},
    NamedControl{"Pin", "pixel/pin"},         NamedControl{"Lessons", "menu/lesson"},
    NamedControl{"Scene", "menu/scene"},      NamedControl{"light 0.1 above", "stability/series"}};

std::string name_of(const LinkTarget& target) {
  switch (target.link.kind) {
  case LinkKind::none:
    return "control:" + target.control;
  case LinkKind::option:
  case LinkKind::control:
    return "option:" + target.link.target;
  case LinkKind::panel:
    return "panel:" + target.link.target;
  case LinkKind::step:
    return fmt::format("step:{}", target.link.step + 1);
  case LinkKind::lesson:
    return fmt::format("lesson:{}/{}", target.link.target, target.link.step + 1);
  case LinkKind::term:
    return "term:" + target.link.target;
  }
  return {};
}

/// What the glossary says of a term, or what is wrong with the glossary.
std::string term_help(const std::string& term) {
  try {
    if (const GlossaryEntry* entry = find_entry(term))
      return fmt::format("{}: {}", entry->term, plain_text(entry->definition));
  } catch (const InputError& error) {
    return error.what();
  }
  return "Opens the glossary.";
}

std::string help_of(const TextLink& link) {
  switch (link.kind) {
  case LinkKind::none:
  case LinkKind::option:
  case LinkKind::control:
    return "Shows where this is.";
  case LinkKind::panel:
    return "Opens this panel.";
  case LinkKind::step:
    return "Goes to this step.";
  case LinkKind::lesson:
    return "Opens this lesson.";
  case LinkKind::term:
    return term_help(link.target);
  }
  return {};
}

/// The end of a piece: up to the next one if both are of the same span, so that a line below them is not broken.
float end_of(const TextLine& line, std::size_t i) {
  const TextPiece& piece = line.pieces[i];
  const bool goes_on = i + 1 < line.pieces.size() && line.pieces[i + 1].span == piece.span;
  return goes_on ? line.pieces[i + 1].x : piece.x + piece.width;
}

bool link_button(const TextPiece& piece, ImVec2 min, ImVec2 max, const LinkTarget& target) {
  const ImVec2 back = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(min);
  ImGui::PushID(static_cast<const void*>(piece.text.data()));  // the same name may be there twice
  const std::string name = "link/" + name_of(target);
  const bool clicked = hit_area(name, {max.x - min.x, max.y - min.y}, {});
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (begin_tooltip()) {
    show_text(help_of(target.link));
    end_tooltip();
  }
  controls().record(name, std::string(piece.span->text));
  ImGui::PopID();
  const Palette& p = palette();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (hovered) draw.AddRectFilled(min, max, colour_u32(p.field_hover), px(3));
  draw.AddLine({min.x, max.y - px(2)}, {max.x, max.y - px(2)}, colour_u32(hovered ? p.text : p.text_quiet), px(1.2));
  ImGui::SetCursorScreenPos(back);
  return clicked;
}

/// `at` is the upper left corner of a word in the formula's place.
void draw_formula(const TextPiece& piece, ImVec2 at) {
  const MathsBox& box = *piece.formula;
  const float baseline = at.y + ascent_of(piece.face), room = ImGui::GetContentRegionAvail().x;
  if (piece.x + box.width > room + 1)
    fit_watch().shortened({at.x, baseline - box.above}, {at.x + box.width, baseline + box.below}, piece.span->text);
  draw_maths(*ImGui::GetWindowDrawList(), {at.x, baseline}, box, WindowMathsFont(maths_faces(piece.face)),
             palette().text);
}

/// Over the whole column. A pointer over it shows its description.
void draw_figure_line(const Figure& figure, ImVec2 at, float height) {
  const float width = ImGui::GetContentRegionAvail().x;
  ScreenPainter painter(*ImGui::GetWindowDrawList());
  draw_figure(painter, figure, paint_place(at), width);
  ImGui::Dummy({width, height});
  tooltip(figure_words(figure));
  controls().record("figure", figure_words(figure));
  ImGui::SetCursorScreenPos({at.x, at.y + height});
}

}  // namespace

std::optional<LinkTarget> target_of(const TextSpan& span) {
  if (span.link.kind == LinkKind::control) return {};
  if (span.link.kind != LinkKind::none) return LinkTarget{span.link, {}};
  if (span.style != TextStyle::strong) return {};
  for (const NamedControl& each : named_controls)
    if (each.word == span.text) return LinkTarget{{}, std::string(each.control)};
  return {};
}

std::optional<LinkTarget> draw_line(Session& session, const TextLine& line) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  std::optional<LinkTarget> clicked;
  const float middle = at.y + line.rise + (line.height - line.rise - line.fall) / 2;
  if (line.need) {
    draw_need(session, *line.need, ImGui::GetContentRegionAvail().x);
    ImGui::SetCursorScreenPos({at.x, at.y + line.height});
    return {};
  }
  if (line.figure && line.pieces.empty()) {
    draw_figure_line(*line.figure, at, line.height);
    return {};
  }
  if (!line.mark.empty()) {
    const float top = std::floor(middle - ImGui::GetFontSize() / 2);
    draw_lines({at.x + px(4), top}, line.mark, palette().text_quiet);
  }
  for (std::size_t i = 0; i < line.pieces.size(); ++i) {
    const TextPiece& piece = line.pieces[i];
    const float x = std::floor(at.x + piece.x);
    if (piece.control) {
      ImGui::SetCursorScreenPos({x, std::floor(middle - ImGui::GetFrameHeight() / 2)});
      ImGui::PushID(piece.span);
      option_field(session, *piece.control, *find_option(piece.span->link.target), piece.width);
      ImGui::PopID();
      continue;
    }
    const FontScope font(piece.face);
    const ImVec2 min{x, at.y}, max{std::floor(at.x + end_of(line, i)), at.y + line.height};
    if (const auto target = target_of(*piece.span); target && link_button(piece, min, max, *target)) clicked = target;
    if (piece.formula) {
      draw_formula(piece, {x, std::floor(middle - ImGui::GetFontSize() / 2)});
      continue;
    }
    if (piece.face == Face::mono && piece.span->style == TextStyle::code)
      draw.AddRectFilled({min.x - px(2), min.y + px(1)}, {max.x + px(2), max.y - px(2)},
                         colour_u32(palette().field_active), px(3));
    draw_lines({x, std::floor(middle - ImGui::GetFontSize() / 2)}, piece.text, palette().text);
  }
  ImGui::SetCursorScreenPos({at.x, at.y + line.height});
  return clicked;
}

std::optional<LinkTarget> draw_text_lines(Session& session, const std::vector<TextLine>& lines, float width) {
  std::optional<LinkTarget> followed;
  const ImVec2 from = ImGui::GetCursorScreenPos();
  ImVec2 at = from;
  for (const TextLine& line : lines) {
    at.y += line.gap;
    ImGui::SetCursorScreenPos(at);
    if (auto clicked = draw_line(session, line)) followed = std::move(clicked);
    at.y += line.height;
  }
  ImGui::SetCursorScreenPos(from);
  ImGui::Dummy({width, at.y - from.y});
  return followed;
}

}  // namespace ps::gui
