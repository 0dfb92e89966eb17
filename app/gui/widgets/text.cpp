#include <imgui_internal.h>

#include <algorithm>

#include "gui/base/fit.h"
#include "gui/widgets/draw.h"

namespace ps::gui {
namespace {

constexpr float least_height = 0.8f;  // of a line: the rest is free above and below its letters

std::string in_room(std::string_view text, const TextForm& form) {
  const FontScope font(form.face);
  return in_lines(text, ImGui::GetContentRegionAvail().x);
}

/// The length of the part of a word that stays together: all of it, but a path or a name that is wider than a line may
/// end behind these signs.
std::size_t kept_together(std::string_view word, float width) {
  if (text_width(word) <= width) return word.size();
  return std::min(word.find_first_of("/_-"), word.size() - 1) + 1;
}

}  // namespace

TextScope::TextScope(const TextForm& form) : font_(form.face) {
  ImGui::PushStyleColor(ImGuiCol_Text, form.quiet ? palette().text_quiet : ImGui::GetStyleColorVec4(ImGuiCol_Text));
}

TextScope::~TextScope() { ImGui::PopStyleColor(); }

void show_text(std::string_view text, const TextForm& form) {
  const TextScope scope(form);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
}

void value_text(std::string_view name, std::string_view text, const TextForm& form) {
  show_text(text, form);
  controls().record(name, std::string(text));
}

void show_paragraph(std::string_view text, const TextForm& form) { show_text(in_room(text, form), form); }

void value_paragraph(std::string_view name, std::string_view text, const TextForm& form) {
  show_paragraph(text, form);
  controls().record(name, std::string(text));
}

void quiet_text(std::string_view text) { show_paragraph(text, {.quiet = true}); }

float text_width(std::string_view text, std::optional<Face> face) {
  const FontScope font(face);
  return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
}

void draw_text(ImVec2 min, ImVec2 max, std::string_view text, const ImVec4& colour, float align,
               std::optional<Face> face) {
  if (text.empty()) return;
  const FontScope font(face);
  const char* begin = text.data();
  const char* end = begin + text.size();
  const ImVec2 size = ImGui::CalcTextSize(begin, end);
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  const float room = max.x - min.x;
  const float y = std::floor((min.y + max.y - size.y) / 2);
  const float x = std::floor(min.x + std::max(0.0f, room - size.x) * align);
  if (size.x > room + 1 || size.y * least_height > max.y - min.y + 1) fit_watch().shortened(min, max, text);
  if (size.x > room + 1)
    ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), {x, y}, {max.x, max.y}, max.x, max.x, begin, end, &size);
  else
    ImGui::GetWindowDrawList()->AddText({x, y}, colour_u32(colour), begin, end);
  ImGui::PopStyleColor();
}

std::string in_lines(std::string_view text, float width) {
  std::string lines, line;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t word_end = std::min(text.find_first_of(" \n", at), text.size());
    const std::string_view part =
        text.substr(at, word_end == at ? 0 : kept_together(text.substr(at, word_end - at), width));
    if (!line.empty() && text_width(line + std::string(part)) > width) {
      if (line.back() == ' ') line.pop_back();
      lines += line + '\n';
      line.clear();
    }
    line += part;
    at += part.size();
    if (at < word_end || at == text.size()) continue;
    line += text[at];
    if (text[at++] != '\n') continue;
    lines += line;
    line.clear();
  }
  return lines + line;
}

}  // namespace ps::gui
