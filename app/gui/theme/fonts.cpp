#include <ft2build.h>
#include <imgui_freetype.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "base/resources.h"
#include "gui/theme/theme.h"

namespace ps::gui {
namespace {

/// Signs that words, formulas, tables and keys use: Latin, Greek, Cyrillic capitals, punctuation, super- and
/// subscripts, letter-like signs, arrows, mathematics, boxes and shapes.
constexpr std::array<ImWchar, 41> wide_ranges{
    0x0020, 0x007E, 0x00A0, 0x017F, 0x0300, 0x0308, 0x0370, 0x03FF, 0x0400, 0x042F, 0x2010, 0x2027, 0x2030, 0x203A,
    0x2070, 0x209C, 0x20AC, 0x20AC, 0x2113, 0x2122, 0x2150, 0x215E, 0x2190, 0x21FF, 0x2200, 0x226F, 0x2282, 0x2282,
    0x2295, 0x22C5, 0x22EF, 0x22EF, 0x2300, 0x2311, 0x2500, 0x25FF, 0x2605, 0x2718, 0x27E8, 0x27E9, 0};
/// What formulas use: letters, digits, Greek, operators, arrows and delimiters.
constexpr std::array<ImWchar, 19> maths_ranges{0x0020, 0x007E, 0x00A0, 0x00FF, 0x0391, 0x03D6, 0x2010,
                                               0x2027, 0x2032, 0x2033, 0x2113, 0x2113, 0x2190, 0x21D4,
                                               0x2200, 0x22EF, 0x2308, 0x230B, 0};
/// For numbers alone.
constexpr std::array<ImWchar, 11> narrow_ranges{0x0020, 0x007E, 0x00A0, 0x00FF, 0x0370, 0x03FF,
                                                0x2010, 0x2027, 0x2190, 0x2193, 0};

struct FaceFile {
  const char* file;
  const ImWchar* ranges;
  const char* fallback;  ///< supplies the glyphs that the first file lacks
};

FaceFile face_file(Face face) {
  constexpr const char* regular = "Inter-Regular.otf";
  constexpr const char* semi_bold = "Inter-SemiBold.otf";
  constexpr const char* mono = "JetBrainsMono-Regular.ttf";
  switch (face) {
  case Face::body:
    return {regular, wide_ranges.data(), mono};
  case Face::bold:
  case Face::heading:
  case Face::caption:
  case Face::small_bold:
    return {semi_bold, wide_ranges.data(), mono};
  case Face::italic:
    return {"Inter-Italic.otf", wide_ranges.data(), mono};
  case Face::caption_italic:
    return {"Inter-SemiBoldItalic.otf", maths_ranges.data(), mono};
  case Face::script:
    return {regular, maths_ranges.data(), mono};
  case Face::script_italic:
    return {"Inter-Italic.otf", maths_ranges.data(), mono};
  case Face::script_bold:
    return {semi_bold, maths_ranges.data(), mono};
  case Face::small:
    return {regular, wide_ranges.data(), mono};
  case Face::mono:
  case Face::mono_small:
    return {mono, wide_ranges.data(), regular};
  case Face::mono_bold:
    return {"JetBrainsMono-Bold.ttf", narrow_ranges.data(), mono};
  }
  return {};
}

/// Height of a line in ems. Dear ImGui measures a font by its line (ascender to descender), people by its em.
double line_height(const std::string& path) {
  double height = 1.2;
  FT_Library library = nullptr;
  if (FT_Init_FreeType(&library) != 0) return height;
  FT_Face face = nullptr;
  if (FT_New_Face(library, path.c_str(), 0, &face) == 0) {
    if (face->units_per_EM > 0)
      height = static_cast<double>(face->ascender - face->descender) / static_cast<double>(face->units_per_EM);
    FT_Done_Face(face);
  }
  FT_Done_FreeType(library);
  return height;
}

/// `em` in pixels. Null if there is no such file.
ImFont* load(const std::string& path, double em, const ImWchar* ranges, bool merge) {
  if (!std::filesystem::exists(path)) return nullptr;
  ImFontConfig config;
  config.MergeMode = merge;
  config.GlyphRanges = ranges;
  const auto size = static_cast<float>(std::round(em * line_height(path)));
  return ImGui::GetIO().Fonts->AddFontFromFileTTF(path.c_str(), size, &config, ranges);
}

}  // namespace

double type_size(Face face) {
  switch (face) {
  case Face::body:
  case Face::bold:
  case Face::italic:
  case Face::mono:
  case Face::mono_bold:
    return 17;
  case Face::small:
  case Face::small_bold:
  case Face::mono_small:
    return 13;
  case Face::heading:
    return 22;
  case Face::caption:
  case Face::caption_italic:
    return 24;
  case Face::script:
  case Face::script_italic:
  case Face::script_bold:
    return 17 * script_size;
  }
  return 17;
}

void Theme::load_fonts() {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  const bool first = this == &theme();  // the projected theme's faces come to those of the window
  if (first) atlas.Clear();
  atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
  atlas.TexDesiredWidth = scale_ > 1.5 ? 4096 : 2048;
  for (int i = 0; i < IM_ARRAYSIZE(fonts_); ++i) {
    const FaceFile face = face_file(static_cast<Face>(i));
    // Small print would be too small behind a projector.
    const double least = first ? 0 : type_size(Face::body);
    const double em = std::max(type_size(static_cast<Face>(i)), least) * scale_;
    fonts_[i] = load(font_file(face.file).string(), em, face.ranges, false);
    if (!fonts_[i]) {
      ImFontConfig config;
      config.SizePixels = static_cast<float>(std::round(em));
      fonts_[i] = atlas.AddFontDefault(&config);
    }
    if (face.fallback) load(font_file(face.fallback).string(), em, face.ranges, true);
  }
  atlas.Build();
  if (first) ImGui::GetIO().FontDefault = fonts_[0];
}

bool Theme::has_glyphs(Face face, const char* utf8) const {
  ImFont* used = font(face);
  // ImGui's own decoder is internal; UTF-8 of the basic plane is short.
  for (const auto* p = reinterpret_cast<const unsigned char*>(utf8); *p;) {
    unsigned code = *p++;
    int more = code >= 0xF0 ? 3 : code >= 0xE0 ? 2 : code >= 0xC0 ? 1 : 0;
    if (more > 0) code &= 0x3Fu >> more;
    for (; more > 0 && (*p & 0xC0u) == 0x80u; --more) code = (code << 6) | (*p++ & 0x3Fu);
    if (code < 0x20) continue;
    if (code > 0xFFFF || !used->FindGlyphNoFallback(static_cast<ImWchar>(code))) return false;
  }
  return true;
}

}  // namespace ps::gui
