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
  p.window = rgb(light ? 0xE6E6E3 : 0x141517);
  p.panel = rgb(light ? 0xF3F3F1 : 0x1A1B1D);
  p.field = rgb(light ? 0xFFFFFF : 0x222326);
  p.field_hover = rgb(light ? 0xECECE9 : 0x2A2C30);
  p.field_active = rgb(light ? 0xE0E0DC : 0x2D3035);
  p.text = rgb(light ? 0x1A1A19 : 0xEFEFEC);
  p.text_quiet = rgb(light ? 0x3A3B39 : 0xCACCCB);
  p.text_disabled = rgb(light ? 0x434442 : 0xBEC0C0);
  p.line = rgb(light ? 0xD6D6D2 : 0x34373A);
  p.line_strong = rgb(light ? 0x7C7D79 : 0x7C8085);
  p.selection = rgb(light ? 0xD9E0E4 : 0x29333B);
  p.a = rgb(0x0072B2);
  p.b = rgb(0xD55E00);
  p.right = rgb(0x009E73);
  p.wrong = rgb(0xCC79A7);
  p.attention = rgb(0xF0E442);
  p.right_mark = rgb(light ? 0x00775A : 0x3FBF97);
  p.wrong_mark = rgb(light ? 0xA04A80 : 0xE09CC3);
  return p;
}

double contrast(const ImVec4& first, const ImVec4& second) {
  const double one = luminance(first), other = luminance(second);
  return (std::max(one, other) + 0.05) / (std::min(one, other) + 0.05);
}

}  // namespace ps::gui
