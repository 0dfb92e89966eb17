#include <algorithm>
#include <cmath>
#include <cstdint>

#include "gui/theme/theme.h"

namespace ps::gui {
namespace {

ImVec4 rgb(std::uint32_t hex) {
  const auto part = [&](int shift) { return static_cast<float>((hex >> shift) & 255u) / 255.0f; };
  return {part(16), part(8), part(0), 1};
}

double linear(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }
double luminance(const ImVec4& c) { return 0.2126 * linear(c.x) + 0.7152 * linear(c.y) + 0.0722 * linear(c.z); }

}  // namespace

Palette make_palette(Brightness brightness) {
  Palette p;
  const bool light = brightness == Brightness::light;
  p.window = rgb(light ? 0xE6E6E3 : 0x17181A);
  p.panel = rgb(light ? 0xF3F3F1 : 0x1F2022);
  p.field = rgb(light ? 0xFFFFFF : 0x2A2C2F);
  p.field_hover = rgb(light ? 0xECECE9 : 0x33363A);
  p.field_active = rgb(light ? 0xE0E0DC : 0x3B3F44);
  p.text = rgb(light ? 0x1A1A19 : 0xEFEFEC);
  p.text_quiet = rgb(light ? 0x3F403E : 0xC6C8C7);
  p.text_disabled = rgb(light ? 0x757673 : 0x8A8D8E);
  p.line = rgb(light ? 0xD6D6D2 : 0x34373A);
  p.line_strong = rgb(light ? 0x9A9B97 : 0x62666A);
  p.selection = rgb(light ? 0xD9E0E4 : 0x34404A);
  p.a = rgb(0x0072B2);
  p.b = rgb(0xD55E00);
  p.right = rgb(0x009E73);
  p.wrong = rgb(0xCC79A7);
  p.attention = rgb(0xF0E442);
  p.a_text = rgb(light ? 0x004B7A : 0x8CCBF2);
  p.b_text = rgb(light ? 0x7D3200 : 0xFFB080);
  p.right_text = rgb(light ? 0x00523A : 0x6FDDB4);
  p.wrong_text = rgb(light ? 0x7A2A58 : 0xF0B3D3);
  p.on_accent = rgb(light ? 0xFFFFFF : 0x101112);
  return p;
}

double contrast(const ImVec4& first, const ImVec4& second) {
  const double one = luminance(first), other = luminance(second);
  return (std::max(one, other) + 0.05) / (std::min(one, other) + 0.05);
}

}  // namespace ps::gui
