#include "gui/panels/story/event_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "gui/panels/story/shown_field.h"
#include "gui/widgets/draw.h"
#include "inspect/describe.h"
#include "inspect/face_data.h"

namespace ps::gui {
namespace {

constexpr std::size_t numbers_in_a_line = 3;

/// The numbers of a field that fits the columns.
std::optional<std::vector<double>> numbers_of(const FieldValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return std::vector{*number};
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::vector{static_cast<double>(*whole)};
  if (const auto* several = std::get_if<std::vector<double>>(&value); several && several->size() <= numbers_in_a_line)
    return *several;
  return {};
}

/// Four digits after the point, so that points are below each other; whole and very small or large numbers as such.
std::string column_text(double value) {
  const double size = std::abs(value);
  if (value == std::round(value) && size < 1e7) return fmt::format("{:.0f}", value);
  if (size >= 0.0005 && size < 100) return fmt::format("{:.4f}", value);
  return size < 1 ? fmt::format("{:.1e}", value) : fmt::format("{:.5g}", value);
}

/// Three digits in all, but whole thousands as such.
std::string brief_text(double value) {
  const double size = std::abs(value);
  return size >= 1000 && size < 1e6 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

using NumberText = std::string (*)(double);

/// How numbers are written, from what reads best to what takes the least room.
struct NumberStyle {
  Face face;
  NumberText text;
  const char* usual;  ///< columns are at least as wide as this, so that they do not jump from event to event
};
constexpr std::array<NumberStyle, 4> styles{{
    {Face::mono, column_text, "-0.0000"},
    {Face::mono, brief_text, "-0.000"},
    {Face::small, brief_text, "-0.000"},
    {Face::small, [](double value) { return fmt::format("{:.2g}", value); }, "-0.00"},
}};

/// How wide a column must be for every number of these fields.
float number_column_width(const std::vector<EventField>& fields, const NumberStyle& style) {
  float widest = text_width(style.usual, style.face);
  for (const EventField& field : fields)
    if (const auto numbers = numbers_of(field.value))
      for (const double number : *numbers) widest = std::max(widest, text_width(style.text(number), style.face));
  return widest + px(9);
}

/// How many columns these fields take.
std::size_t columns_of(const std::vector<EventField>& fields) {
  std::size_t most = 1;
  for (const EventField& field : fields)
    if (const auto numbers = numbers_of(field.value)) most = std::max(most, numbers->size());
  return most;
}

/// Is it the number of a light? The title of its row in the story has the same number, so it is not shown again.
bool counts_a_light(const EventField& field) {
  return field.key == "light" && std::holds_alternative<std::int64_t>(field.value);
}

/// The old text of a field of that name; empty where it reads the same.
std::string value_then(const std::vector<FieldText>& before, const FieldText& now) {
  for (const FieldText& old : before)
    if (old.name == now.name) return old.exact == now.exact ? std::string() : old.value + " →";
  return {};
}

}  // namespace

std::optional<ClickedNumber> event_numbers(const std::string& name, const Event& event, const Scene& scene,
                                           const Event* before) {
  std::optional<ClickedNumber> clicked;
  const auto fields = event_fields(event.data, scene);
  const std::size_t own = event_fields(event.data).size();  // those behind them are the model's, not the kernel's
  const auto texts = event_table(event, scene);             // the same fields in words
  const auto then = before ? event_table(*before, scene) : std::vector<FieldText>{};
  const float left = px(6), room = ImGui::GetContentRegionMax().x - left;  // the tree's indent would cost too much room
  float names = 0;
  for (const auto& text : texts) names = std::max(names, text_width(text.name, Face::small));
  const auto used = static_cast<float>(columns_of(fields));
  const auto beside = [&](const NumberStyle& style) { return room - number_column_width(fields, style) * used; };
  // Numbers in shorter forms beside their names, or else in the longest form that fits below them.
  auto style = std::find_if(styles.begin(), styles.begin() + 2,
                            [&](const NumberStyle& one) { return beside(one) >= names + px(8); });
  if (style == styles.begin() + 2)
    style =
        std::find_if(styles.begin() + 1, styles.end() - 1, [&](const NumberStyle& one) { return beside(one) >= 0; });
  const float column = number_column_width(fields, *style);
  const FontScope digits(style->face);
  names = std::min(names + px(8), std::max(room - column * used, 0.f));
  float farthest = 0;  // window pixels
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (counts_a_light(fields[i])) continue;
    if (const std::string old = value_then(then, texts[i]); !old.empty()) {
      ImGui::SetCursorPosX(left + names);
      quiet_text(old);
    }
    ImGui::SetCursorPosX(left);
    show_text(texts[i].name, {Face::small, true});
    const float name_width = ImGui::GetItemRectSize().x;
    // Where a name leaves no room beside it, its value is below.
    bool first = true;
    const auto place = [&](float at) {
      if (std::exchange(first, false) && left + name_width > at - px(4))
        ImGui::SetCursorPosX(at);
      else
        ImGui::SameLine(at);
    };
    const auto numbers = numbers_of(fields[i].value);
    if (!numbers) {
      place(left + names);
      show_paragraph(texts[i].value);
    } else {
      for (std::size_t k = 0; k < numbers->size(); ++k) {
        const std::string text = style->text((*numbers)[k]);
        const float width = text_width(text);
        place(left + names + column * static_cast<float>(k + 1) - width);
        show_text(text);
        farthest = std::max(farthest, ImGui::GetItemRectMax().x);
        if (i >= own) {
          tooltip(full_number((*numbers)[k]));
          continue;
        }
        const bool vector = numbers->size() > 1;
        controls().record(fmt::format("{}/{}{}", name, fields[i].key, vector ? fmt::format(".{}", k) : ""), text);
        if (number_to_show(full_number((*numbers)[k])))
          clicked = {std::string(fields[i].key), vector ? static_cast<int>(k) : -1};
      }
    }
    if (!numbers && texts[i].exact != texts[i].value) tooltip(texts[i].exact);
  }
  const float edge = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x;
  controls().record("event-numbers", farthest <= edge ? "all in sight" : "cut");
  return clicked;
}

}  // namespace ps::gui
