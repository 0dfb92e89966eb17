#pragma once
#include <imgui.h>

namespace ps::gui {

enum class Brightness { light, dark };

/// Every colour of the window by its role. Text colours reach a contrast of 7:1 on `window`, `panel` and `field`.
struct Palette {
  ImVec4 window, panel, field, field_hover, field_active;  ///< backgrounds, from the farthest to the nearest
  ImVec4 text, text_quiet, text_disabled, line, line_strong;
  ImVec4 selection;                               ///< background of selected rows and segments
  ImVec4 a, b, right, wrong, attention;           ///< Okabe-Ito, for marks and areas
  ImVec4 a_text, b_text, right_text, wrong_text;  ///< the same hues, dark or light enough to be read as text
  ImVec4 on_accent;                               ///< text on a, b, right or wrong
};
Palette make_palette(Brightness brightness);
/// Contrast of two opaque sRGB colours after WCAG 2: 1 to 21.
double contrast(const ImVec4& first, const ImVec4& second);

enum class Face { body, bold, italic, heading, title, small, small_bold, mono, mono_bold };
inline constexpr int face_count = 9;

/// Loads the fonts, applies colours and sizes to Dear ImGui, and rebuilds all of it when scale or brightness change.
class Theme {
 public:
  static constexpr double min_scale = 0.75, max_scale = 4;

  Brightness brightness() const { return brightness_; }
  double scale() const { return scale_; }
  /// Both take effect between frames, in prepare().
  void set_brightness(Brightness brightness);
  void set_scale(double scale);
  /// Call between frames. True if the font atlas changed and its texture must be made anew.
  bool prepare();

  const Palette& palette() const { return palette_; }
  ImFont* font(Face face) const { return fonts_[static_cast<int>(face)]; }
  /// Whether every code point of the UTF-8 text has a glyph in the face.
  bool has_glyphs(Face face, const char* utf8) const;

 private:
  void load_fonts();
  Brightness brightness_ = Brightness::light;
  double scale_ = 1;
  bool fonts_stale_ = true, colours_stale_ = true;
  Palette palette_;
  ImFont* fonts_[face_count] = {};
};

/// The one theme.
Theme& theme();
inline const Palette& palette() { return theme().palette(); }
/// Pixels at the current scale: px(17) is the em of body text.
inline float px(double at_scale_1) { return static_cast<float>(at_scale_1 * theme().scale()); }
inline ImU32 colour_u32(const ImVec4& c, double alpha = 1) {
  return ImGui::ColorConvertFloat4ToU32({c.x, c.y, c.z, c.w * static_cast<float>(alpha)});
}
/// ImGui::PushFont for one scope.
class FontScope {
 public:
  explicit FontScope(Face face) { ImGui::PushFont(theme().font(face)); }
  ~FontScope() { ImGui::PopFont(); }
  FontScope(const FontScope&) = delete;
  FontScope& operator=(const FontScope&) = delete;
};

}  // namespace ps::gui
