// Legibility: contrast of every text colour on every background, and a glyph for every sign that help and lessons use.
#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "base/resources.h"
#include "engine/maths_shapes.h"
#include "engine/maths_signs.h"
#include "gui/program.h"
#include "gui/theme/contrast.h"
#include "gui/theme/projected_type.h"
#include "gui/widgets/maths_draw.h"
#include "options/option.h"
#include "study/chart_style.h"

namespace theme_test {
namespace {

using namespace ps::gui;

TEST(Theme, ContrastMatchesTheDefinition) {
  EXPECT_NEAR(contrast({0, 0, 0, 1}, {1, 1, 1, 1}), 21, 1e-6);
  EXPECT_NEAR(contrast({1, 1, 1, 1}, {1, 1, 1, 1}), 1, 1e-6);
  const float grey = 0x76 / 255.0f;  // #767676 on white is the well-known limit of 4.5
  EXPECT_NEAR(contrast({grey, grey, grey, 1}, {1, 1, 1, 1}), 4.54, 0.01);
}

TEST(Theme, TextReachesSevenToOneAndMarksThreeToOne) {
  for (const Brightness brightness : {Brightness::light, Brightness::dark}) {
    const std::vector<std::string> faults = contrast_faults(make_palette(brightness));
    EXPECT_TRUE(faults.empty()) << (brightness == Brightness::dark ? "dark: " : "light: ") << faults.size()
                                << " such as " << faults.front();
  }
}

/// The check sees a text, a mark and a ground that are too pale.
TEST(Theme, AColourThatStandsOutTooLittleIsFound) {
  const auto found = [](const Palette& palette, const std::string& pair) {
    const std::vector<std::string> faults = contrast_faults(palette);
    return std::any_of(faults.begin(), faults.end(), [&](const std::string& fault) { return fault.starts_with(pair); });
  };
  for (const Brightness brightness : {Brightness::light, Brightness::dark}) {
    const Palette good = make_palette(brightness);
    Palette planted = good;
    planted.text_disabled = {0x75 / 255.f, 0x76 / 255.f, 0x73 / 255.f, 1};
    EXPECT_TRUE(found(planted, "text_disabled on panel"));
    EXPECT_TRUE(found(planted, "ImGui's TextDisabled on PopupBg"));
    EXPECT_FALSE(found(planted, "text on panel"));
    planted = good;
    planted.b = planted.panel;
    EXPECT_TRUE(found(planted, "b on panel: 1.00, needs 3"));
    planted = good;
    planted.selection = {0.5f, 0.5f, 0.5f, 1};
    EXPECT_TRUE(found(planted, "text on selection"));
    EXPECT_TRUE(found(planted, "ImGui's Text on Header"));
  }
}

TEST(Theme, TypeHasFourSizesAndThatOfScripts) {
  std::set<double> sizes;
  for (int face = 0; face < face_count; ++face) sizes.insert(type_size(static_cast<Face>(face)));
  EXPECT_EQ(sizes, (std::set<double>{0.7 * 17, 13, 17, 22, 24}));
}

TEST(Theme, PaddingsLieOnAGridOfEight) {
  const ImGuiStyle style = sizes_at_scale_1();
  const auto half_steps = [](float length) { return length / 4 == std::floor(length / 4); };
  for (const ImVec2& padding :
       {style.WindowPadding, style.FramePadding, style.ItemSpacing, style.ItemInnerSpacing, style.CellPadding}) {
    EXPECT_TRUE(half_steps(padding.x) && padding.x >= 8) << padding.x;
    EXPECT_TRUE(half_steps(padding.y)) << padding.y;
  }
  EXPECT_TRUE(half_steps(style.IndentSpacing));
}

/// What is no picture's has no picture's colour: sources name the two by the palette, and only beside a side.
TEST(Theme, ColoursOfAAndBAreUsedForThemAlone) {
  const std::vector<std::string> numbers{"0072B2", "D55E00", "0, 114, 178", "213, 94, 0"};
  int uses = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator("app/gui")) {
    if (!entry.is_regular_file() || entry.path().string().find("app/gui/theme") != std::string::npos) continue;
    const std::string text = ps::test::read_file(entry.path());
    for (const std::string& number : numbers) EXPECT_EQ(text.find(number), std::string::npos) << entry.path();
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      for (const std::string colour : {"palette().a", "palette().b", "p.a", "p.b"}) {
        const auto at = line.find(colour);
        if (at == std::string::npos || (at > 0 && (std::isalnum(line[at - 1]) || line[at - 1] == '_'))) continue;
        const char after = at + colour.size() < line.size() ? line[at + colour.size()] : ' ';
        if (std::isalnum(after) || after == '_' || line.find("std::abs(") != std::string::npos ||
            line.find("Bgra8") != std::string::npos)
          continue;
        ++uses;
        const bool of_a_side = line.find("Side::a") != std::string::npos || line.find("shown.") != std::string::npos;
        EXPECT_TRUE(of_a_side) << entry.path() << ": " << line;
      }
    }
  }
  EXPECT_GT(uses, 3);
}

TEST(Theme, AccentsAreOkabeAndIto) {
  const Palette p = make_palette(Brightness::light);
  EXPECT_EQ(colour_u32(p.a), IM_COL32(0, 114, 178, 255));
  EXPECT_EQ(colour_u32(p.b), IM_COL32(213, 94, 0, 255));
  EXPECT_EQ(colour_u32(p.right), IM_COL32(0, 158, 115, 255));
  EXPECT_EQ(colour_u32(p.wrong), IM_COL32(204, 121, 167, 255));
  EXPECT_EQ(colour_u32(p.attention), IM_COL32(240, 228, 66, 255));
}

/// Charts mark points by renderer and precision, in colours of their own that stand out on both grounds.
TEST(Theme, ChartMarksAreNeitherAsNorBs) {
  const auto colour_of = [](ps::Rgb8 c) {
    return ImVec4{static_cast<float>(c.r) / 255, static_cast<float>(c.g) / 255, static_cast<float>(c.b) / 255, 1};
  };
  std::set<ImU32> seen;
  for (const Brightness brightness : {Brightness::light, Brightness::dark}) {
    const Palette p = make_palette(brightness);
    for (std::size_t renderer = 0; renderer < ps::renderer_kinds().size(); ++renderer)
      for (const ps::Precision precision : {ps::Precision::float32, ps::Precision::float64}) {
        ps::Settings settings;
        settings.renderer = static_cast<ps::Renderer>(renderer);
        settings.precision = precision;
        const ImVec4 colour = colour_of(ps::mark_colour(settings));
        seen.insert(colour_u32(colour));
        EXPECT_GE(contrast(colour, p.field), mark_contrast) << renderer;
        EXPECT_NE(colour_u32(colour), colour_u32(p.a));
        EXPECT_NE(colour_u32(colour), colour_u32(p.b));
      }
  }
  EXPECT_GE(seen.size(), 5u);
}

class Glyphs : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(ps::font_file("Inter-Regular.otf"))) GTEST_SKIP() << "Inter is not installed";
    ImGui::CreateContext();
    theme().set_scale(theme().scale() == 1 ? 1.25 : 1);  // another than before: fonts belong to a context
    theme().prepare();
  }
  void TearDown() override {
    if (ImGui::GetCurrentContext()) ImGui::DestroyContext();
  }
  void expect_glyphs(const std::string& text, const std::string& where) {
    for (const Face face : {Face::body, Face::bold, Face::mono})
      EXPECT_TRUE(theme().has_glyphs(face, text.c_str())) << where << ": " << text;
  }
};

/// The presenter's tool: all of it grows as text grows to the size of the caption, and shrinks again after it.
TEST_F(Glyphs, OfProjectedTypeHaveTheSizeOfTheCaption) {
  ImGui::GetIO().IniFilename = nullptr;
  ImGui::GetIO().DisplaySize = {800, 600};
  want_projected_type(true);
  EXPECT_TRUE(prepare_themes());
  EXPECT_FALSE(prepare_themes()) << "they are loaded once";
  ImGui::NewFrame();
  const float text = ImGui::GetFontSize(), caption = theme().font(Face::caption)->FontSize, em = px(17),
              code = theme().font(Face::mono)->FontSize, space = ImGui::GetStyle().ItemSpacing.x;
  {
    const ProjectedType type;
    EXPECT_NEAR(ImGui::GetFontSize(), caption, 1);
    EXPECT_NEAR(theme().font(Face::mono)->FontSize / code, 24.0 / 17, 0.1);
    EXPECT_NEAR(px(17), em * 24 / 17, 0.01);
    EXPECT_GT(ImGui::GetStyle().ItemSpacing.x, space);
  }
  EXPECT_EQ(ImGui::GetFontSize(), text);
  EXPECT_EQ(px(17), em);
  EXPECT_EQ(ImGui::GetStyle().ItemSpacing.x, space);
  ImGui::Render();
  want_projected_type(false);
}

TEST_F(Glyphs, OfOptionHelp) {
  for (const ps::Option& option : ps::option_table()) {
    for (const auto text :
         {option.label, option.group, option.unit, option.help.what, option.help.source, option.help.fails})
      expect_glyphs(std::string(text), std::string(option.key));
    for (const ps::Choice& choice : option.choices)
      for (const auto text : {choice.label, choice.help}) expect_glyphs(std::string(text), std::string(option.key));
  }
}

TEST_F(Glyphs, OfLessons) {
  if (!std::filesystem::exists(ps::chapter_dir())) GTEST_SKIP() << "no lessons yet";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(ps::chapter_dir()))
    if (entry.path().extension() == ".md") expect_glyphs(ps::test::read_file(entry.path()), entry.path());
}

TEST_F(Glyphs, OfFormulas) {
  expect_glyphs("αβγδεθλμπρσφω ΔΣΩ ←↑→↓↔⇒ ⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ ₀₁₂₃₄₅₆₇₈₉ × · ∞ ± ≠ ≈ ≤ ≥ √ ° − – — … “ ” ‘ ’ äöüßéø",
                "formulas");
}

/// In every face in which formulas are set; some delimiters are drawn with lines instead.
TEST_F(Glyphs, OfTheCommandsOfFormulas) {
  for (const Face text : {Face::body, Face::caption}) {
    const MathsFaces faces = maths_faces(text);
    for (const ps::SignCommand& command : ps::sign_commands()) {
      const std::string& sign = command.sign.text;
      if (ps::always_drawn(sign)) continue;
      for (const Face face : command.sign.style == ps::MathsStyle::italic
                                 ? std::vector{faces.italic, faces.script_italic}
                                 : std::vector{faces.upright, faces.script})
        EXPECT_TRUE(theme().has_glyphs(face, sign.c_str())) << command.name << ": " << sign;
    }
  }
}

TEST_F(Glyphs, AreMissedWhereTheyAreMissing) {
  EXPECT_FALSE(theme().has_glyphs(Face::body, "漢"));
  EXPECT_FALSE(theme().has_glyphs(Face::body, "😀"));
}

}  // namespace
}  // namespace theme_test
