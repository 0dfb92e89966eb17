#pragma once
#include <imgui.h>

#include <optional>

namespace ps::gui {

enum class Brightness { light, dark };

/// Every colour of the window by its role. contrast_faults() (theme/contrast.h) says which contrasts they must have.
struct Palette {
  ImVec4 window, panel, field, field_hover, field_active;  ///< backgrounds, from the farthest to the nearest
  ImVec4 text, text_quiet, text_disabled, line, line_strong;
  ImVec4 selection;                ///< background of selected rows and segments
  ImVec4 a, b;                     ///< Okabe-Ito: bars and rings of the two pictures, and nothing else; never text
  ImVec4 right, wrong, attention;  ///< Okabe-Ito: areas, with an edge of `text_quiet` wherever they lie on a panel
  ImVec4 right_mark, wrong_mark;   ///< the same hues for thin lines and small signs
};
Palette make_palette(Brightness brightness);
/// Contrast of two opaque sRGB colours after WCAG 2: 1 to 21.
double contrast(const ImVec4& first, const ImVec4& second);

enum class Face {
  body,
  bold,
  italic,
  heading,
  caption,
  caption_italic,
  small,
  small_bold,
  mono,
  mono_bold,
  mono_small,
  script,  ///< sub- and superscripts of formulas in body text, as the next two
  script_italic,
  script_bold
};
inline constexpr int face_count = 14;
/// Scripts in formulas, as a share of the size of the text around them.
inline constexpr double script_size = 0.7;
/// Size of a face's em in pixels at scale 1: 13 (small print), 17 (text and controls), 22 (headings), 24 (the
/// presenter's caption); of scripts their share of 17.
double type_size(Face face);
/// Paddings and distances at scale 1, on a grid of 8 with half steps.
ImGuiStyle sizes_at_scale_1();
/// Dear ImGui's colours for a palette.
void apply_colours(const Palette& palette, ImVec4 (&colours)[ImGuiCol_COUNT]);

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
/// ImGui::PushFont for one scope; without a face the present font stays.
class FontScope {
 public:
  explicit FontScope(std::optional<Face> face) { ImGui::PushFont(face ? theme().font(*face) : ImGui::GetFont()); }
  ~FontScope() { ImGui::PopFont(); }
  FontScope(const FontScope&) = delete;
  FontScope& operator=(const FontScope&) = delete;
};

}  // namespace ps::gui
