#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "gui/widgets/draw.h"

namespace ps::gui {

std::string short_number(double value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
  if (value == 0) return "0";
  const double size = std::abs(value);
  if (size < 1e-4 || size >= 1e7) return fmt::format("{:.3e}", value);
  if (value == std::floor(value)) return fmt::format("{:.0f}", value);
  const int digits_before = static_cast<int>(std::floor(std::log10(size))) + 1;
  std::string text = fmt::format("{:.{}f}", value, std::max(0, 4 - digits_before));
  // Rounding may have left zeros at the end; they say nothing.
  if (text.find('.') != std::string::npos) {
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
  }
  return text;
}

std::string full_number(double value) { return fmt::format("{}", value); }

void number_text(std::string_view digits, float width, std::string_view full) {
  const float room = width > 0 ? width : ImGui::GetContentRegionAvail().x;
  const float shift = room - text_width(digits, Face::mono);
  if (shift > 0) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::floor(shift));
  show_text(digits, {Face::mono});
  if (full != digits) tooltip(full);
}

void number_text(double value, float width) { number_text(short_number(value), width, full_number(value)); }

}  // namespace ps::gui
