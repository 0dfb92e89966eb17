// Legibility: contrast of every text colour on every background, and a glyph for every sign that help and lessons use.
#include <gtest/gtest.h>
#include <imgui.h>

#include <filesystem>
#include <string>

#include "base/resources.h"
#include "gui/program.h"
#include "gui/theme/theme.h"
#include "options/option.h"

namespace {

using namespace ps::gui;

TEST(Theme, ContrastMatchesTheDefinition) {
  EXPECT_NEAR(contrast({0, 0, 0, 1}, {1, 1, 1, 1}), 21, 1e-6);
  EXPECT_NEAR(contrast({1, 1, 1, 1}, {1, 1, 1, 1}), 1, 1e-6);
  const float grey = 0x76 / 255.0f;  // #767676 on white is the well-known limit of 4.5
  EXPECT_NEAR(contrast({grey, grey, grey, 1}, {1, 1, 1, 1}), 4.54, 0.01);
}

TEST(Theme, TextReachesSevenToOne) {
  for (const Brightness brightness : {Brightness::light, Brightness::dark}) {
    const Palette p = make_palette(brightness);
    for (const ImVec4& ground : {p.window, p.panel, p.field})
      for (const ImVec4& text : {p.text, p.text_quiet, p.a_text, p.b_text, p.right_text, p.wrong_text})
        EXPECT_GE(contrast(text, ground), 7) << text.x << ' ' << text.y << ' ' << text.z;
    for (const ImVec4& ground : {p.field_hover, p.field_active, p.selection}) EXPECT_GE(contrast(p.text, ground), 7);
    for (const ImVec4& ground : {p.a_text, p.b_text, p.right_text, p.wrong_text})
      EXPECT_GE(contrast(p.on_accent, ground), 7);
  }
}

TEST(Theme, AccentsAreOkabeAndIto) {
  const Palette p = make_palette(Brightness::light);
  EXPECT_EQ(colour_u32(p.a), IM_COL32(0, 114, 178, 255));
  EXPECT_EQ(colour_u32(p.b), IM_COL32(213, 94, 0, 255));
  EXPECT_EQ(colour_u32(p.right), IM_COL32(0, 158, 115, 255));
  EXPECT_EQ(colour_u32(p.wrong), IM_COL32(204, 121, 167, 255));
  EXPECT_EQ(colour_u32(p.attention), IM_COL32(240, 228, 66, 255));
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

TEST_F(Glyphs, AreMissedWhereTheyAreMissing) {
  EXPECT_FALSE(theme().has_glyphs(Face::body, "漢"));
  EXPECT_FALSE(theme().has_glyphs(Face::body, "😀"));
}

}  // namespace
