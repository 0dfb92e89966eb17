#include "gui/app/event_numbers.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "gui/widgets/widgets.h"
#include "inspect/describe.h"
#include "inspect/number_text.h"

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

}  // namespace

void event_numbers(const Event& event, const Scene& scene) {
  const auto fields = event_fields(event.data);
  const auto texts = event_table(event, scene);  // the same fields in words
  const float left = ImGui::GetCursorPosX(), room = ImGui::GetContentRegionAvail().x;
  float names = 0;
  for (const auto& text : texts) names = std::max(names, ImGui::CalcTextSize(text.name.c_str()).x);
  names = std::min(names + px(10), room * 0.42f);
  const FontScope mono(Face::mono);
  const float column = std::min(px(86), (room - names) / static_cast<float>(columns));
  for (std::size_t i = 0; i < texts.size(); ++i) {
    {
      const FontScope body(Face::small);
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
        const std::string text = ps::number_text((*numbers)[k]);
        const float width = ImGui::CalcTextSize(text.c_str()).x;
        ImGui::SameLine(left + names + column * static_cast<float>(k + 1) - width);
        ImGui::TextUnformatted(text.c_str());
      }
    }
    if (texts[i].exact != texts[i].value) tooltip(texts[i].exact);
  }
}

}  // namespace ps::gui
