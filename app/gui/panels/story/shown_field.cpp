#include "gui/panels/story/shown_field.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/check.h"
#include "base/number_text.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/text_field.h"
#include "render/render.h"

namespace ps::gui {
namespace {

/// Marks what a condition asks for as soon as it can be read.
void mark(Session& session, const std::string& typed) {
  std::optional<FieldCondition> condition;
  try {
    if (!typed.empty()) condition = parse_field_condition(typed);
  } catch (const InputError&) {
    return;  // half typed
  }
  session.edit("mark pixels", "mark", [&](Document& document) { document.field->condition = condition; });
}

void show_colours(Session& session) {
  session.edit("show the colours", "channel", [](Document& document) {
    for (SideState* side : {&document.a, &document.b})
      if (side->show == ShownChannel::field) side->show = ShownChannel::colour;
    document.field.reset();
  });
}

/// The pixels that meet the condition, counted once for a picture.
std::size_t count_of(const std::shared_ptr<const RenderResult>& result, const FieldCondition& condition,
                     ShownFieldState& state) {
  if (state.result == result && state.condition == condition) return state.count;
  state.result = result;
  state.condition = condition;
  const auto& values = result->frame.field.pixels();
  state.count = static_cast<std::size_t>(
      std::count_if(values.begin(), values.end(), [&](float value) { return condition.met_by(value); }));
  return state.count;
}

/// The first pixel after `after` in reading order that meets it, or the first of all.
std::optional<Vec2i> next_met(const Image<float>& values, const FieldCondition& condition, std::optional<Vec2i> after) {
  std::optional<Vec2i> first;
  for (int y = 0; y < values.height(); ++y)
    for (int x = 0; x < values.width(); ++x) {
      if (!condition.met_by(values.at(x, y))) continue;
      if (!after || y > after->y || (y == after->y && x > after->x)) return Vec2i(x, y);
      if (!first) first = Vec2i(x, y);
    }
  return first;
}

/// How many meet it, and the way to the next.
void count_and_next(Session& session, Side side, const FieldCondition& condition, ShownFieldState& state) {
  const auto result = session.renderer(side).result();
  if (!result || result->frame.field.empty() || !result->frame.shown_field ||
      result->frame.shown_field->query != session.document().field->query)
    return quiet_text("being computed");
  const std::size_t count = count_of(result, condition, state);
  value_text("count", fmt::format("{} pixels", with_thousands(std::to_string(count))));
  same_line_if_room(button_width("Next"));
  if (button("next", "Next", Emphasis::plain,
             {.tooltip = "To the next pixel that meets it.", .disabled = count > 0 ? "" : "No pixel meets it."}))
    session.set_pixel(next_met(result->frame.field, condition, session.pixel()));
}

}  // namespace

bool number_to_show(std::string_view exact) {
  if (ImGui::IsItemHovered()) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddLine({low.x, high.y}, high, colour_u32(palette().text_quiet));
  }
  tooltip(fmt::format("{}{}Click: shows this number for every pixel.", exact, exact.empty() ? "" : "\n"));
  return ImGui::IsItemClicked();
}

void show_field(Session& session, const FieldQuery& query) {
  session.edit("show " + field_query_words(query), "channel", [&](Document& document) {
    document.field = ShownField{query, {}};
    document.a.show = document.b.show = ShownChannel::field;
  });
}

void shown_field_bar(Session& session, Side side, ShownFieldState& state) {
  const auto& field = session.document().field;
  if (!field || session.shown(side) != ShownChannel::field) return;
  const NameScope names("field");
  value_paragraph("shown", "In the pictures: " + field_query_words(field->query), {Face::bold});
  if (const auto reason = no_field_reason(session.settings(side).renderer, field->query); !reason.empty())
    quiet_text(reason);
  if (text_field("mark", state.typed, "Mark pixels: < 0.001", {.width = px(200)}).changed) mark(session, state.typed);
  same_line_if_room(button_width("Colours"));
  if (button("close", "Colours", Emphasis::plain, {.tooltip = "The pictures show colours again."})) {
    state.typed.clear();
    return show_colours(session);
  }
  if (field->condition) count_and_next(session, side, *field->condition, state);
  ImGui::Separator();
}

}  // namespace ps::gui
