#include "gui/app/event_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "gui/widgets/widgets.h"
#include "inspect/describe.h"

namespace ps::gui {
namespace {

constexpr std::size_t columns = 3;

/// The numbers of a field that fits the columns.
std::optional<std::vector<double>> numbers_of(const FieldValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return std::vector{*number};
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::vector{static_cast<double>(*whole)};
  if (const auto* several = std::get_if<std::vector<double>>(&value); several && several->size() <= columns)
    return *several;
  return {};
}

/// Four digits after the point, so that points stand below each other; whole and very small or large numbers as such.
std::string column_text(double value) {
  const double size = std::abs(value);
  if (value == std::round(value) && size < 1e7) return fmt::format("{:.0f}", value);
  if (size >= 0.0005 && size < 100) return fmt::format("{:.4f}", value);
  return size < 1 ? fmt::format("{:.1e}", value) : fmt::format("{:.5g}", value);
}

/// What a field of that name had, or nothing where it reads the same.
std::string value_then(const std::vector<FieldText>& before, const FieldText& now) {
  for (const FieldText& old : before)
    if (old.name == now.name) return old.exact == now.exact ? std::string() : old.value + " →";
  return {};
}

}  // namespace

void event_numbers(const Event& event, const Scene& scene, const Event* before) {
  const auto fields = event_fields(event.data);
  const auto texts = event_table(event, scene);  // the same fields in words
  const auto then = before ? event_table(*before, scene) : std::vector<FieldText>{};
  const float left = px(6), room = ImGui::GetContentRegionMax().x - left;  // the tree's indent would cost too much room
  float names = 0;
  {
    const FontScope small(Face::small);
    for (const auto& text : texts) names = std::max(names, ImGui::CalcTextSize(text.name.c_str()).x);
  }
  const FontScope mono(Face::mono);
  const float column = ImGui::CalcTextSize("-0.0000").x + px(5);
  names = std::min(names + px(8), std::max(room - column * static_cast<float>(columns), px(40)));
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (const std::string old = value_then(then, texts[i]); !old.empty()) {
      ImGui::SetCursorPosX(left + names);
      ImGui::PushStyleColor(ImGuiCol_Text, palette().wrong_text);
      ImGui::PushTextWrapPos(0);
      ImGui::TextUnformatted(old.c_str());
      ImGui::PopTextWrapPos();
      ImGui::PopStyleColor();
    }
    {
      const FontScope small(Face::small);
      ImGui::SetCursorPosX(left);
      ImGui::PushStyleColor(ImGuiCol_Text, palette().text_quiet);
      ImGui::TextUnformatted(texts[i].name.c_str());
      ImGui::PopStyleColor();
    }
    const auto numbers = numbers_of(fields[i].value);
    if (!numbers) {
      ImGui::SameLine(left + names);
      ImGui::PushTextWrapPos(0);
      ImGui::TextUnformatted(texts[i].value.c_str());
      ImGui::PopTextWrapPos();
    } else {
      for (std::size_t k = 0; k < numbers->size(); ++k) {
        const std::string text = column_text((*numbers)[k]);
        const float width = ImGui::CalcTextSize(text.c_str()).x;
        ImGui::SameLine(left + names + column * static_cast<float>(k + 1) - width);
        ImGui::TextUnformatted(text.c_str());
      }
    }
    if (texts[i].exact != texts[i].value) tooltip(texts[i].exact);
  }
}

}  // namespace ps::gui
