// That cut texts and overlapping controls are found: both are planted here, and what is in order stands beside them.
#include "gui/base/fit.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <functional>
#include <string>

#include "gui/theme/theme.h"
#include "gui/widgets/widgets.h"

namespace fit_test {
namespace {

using namespace ps::gui;

class Fit : public testing::Test {
 protected:
  void SetUp() override {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().DisplaySize = {800, 600};
    theme().set_scale(theme().scale() == 1 ? 1.25 : 1);  // another than before: fonts belong to a context
    theme().prepare();
  }
  void TearDown() override { ImGui::DestroyContext(); }

  /// Draws a few frames: sizes of child windows are known in the second.
  static void draw(const std::function<void()>& content) {
    for (int frame = 0; frame < 3; ++frame) {
      ImGui::NewFrame();
      ImGui::SetNextWindowPos({0, 0});
      ImGui::SetNextWindowSize({400, 300});
      ImGui::Begin("window", nullptr, ImGuiWindowFlags_NoDecoration);
      content();
      ImGui::End();
      ImGui::Render();
    }
  }
};

TEST_F(Fit, WhatFitsIsNotNamed) {
  draw([] {
    button("one", "One");
    ImGui::SameLine();
    button("two", "Two");
    value_text("line", "some words");
  });
  EXPECT_EQ(fit_watch().cut(), "");
  EXPECT_EQ(fit_watch().overlap(), "");
}

TEST_F(Fit, ATextThatIsWiderThanItsControlIsNamed) {
  draw([] { button("narrow", "Measure everything", Emphasis::plain, {.width = 40}); });
  EXPECT_EQ(fit_watch().cut(), "narrow 'Measure everything'");
  EXPECT_EQ(fit_watch().overlap(), "");
}

TEST_F(Fit, AControlOutsideItsWindowIsNamed) {
  draw([] {
    ImGui::SetCursorPos({340, 20});
    button("beyond", "A button that reaches beyond the edge");
  });
  EXPECT_EQ(fit_watch().cut(), "beyond");
  draw([] {
    ImGui::SetCursorPos({20, 290});
    button("below", "Below");
  });
  EXPECT_EQ(fit_watch().cut(), "below");
}

TEST_F(Fit, WhatCanBeScrolledToIsInOrder) {
  const auto list = [] {
    ImGui::BeginChild("list", {200, 100});
    for (int i = 0; i < 20; ++i) button("row-" + std::to_string(i), "Row");
    ImGui::EndChild();
  };
  draw(list);
  EXPECT_EQ(fit_watch().cut(), "");
  draw([] {
    ImGui::BeginChild("list", {200, 40}, false, ImGuiWindowFlags_NoScrollbar);
    for (int i = 0; i < 3; ++i) button("row-" + std::to_string(i), "Row");
    ImGui::EndChild();
  });
  EXPECT_EQ(fit_watch().cut(), "row-1; row-2");
}

TEST_F(Fit, APathWithoutBlanksIsBrokenBehindItsSigns) {
  const std::string path = "/home/someone/pictures/of-scenes/with_long_names/reflections/final_version.png";
  draw([&] { value_text("path", path); });
  EXPECT_EQ(fit_watch().cut(), "path");  // it has no room in one line
  draw([&] { value_paragraph("path", path); });
  EXPECT_EQ(fit_watch().cut(), "");
}

TEST_F(Fit, OverlappingControlsAreNamed) {
  draw([] {
    ImGui::SetCursorPos({20, 20});
    button("below", "Below");
    ImGui::SetCursorPos({50, 30});
    button("above", "Above");
    ImGui::SetCursorPos({20, 80});
    button("apart", "Apart");
  });
  EXPECT_EQ(fit_watch().overlap(), "below and above");
}

TEST_F(Fit, PartsOfAControlAndOtherWindowsMayOverlap) {
  draw([] {
    ImGui::SetCursorPos({20, 20});
    button("choice", "A wide choice");
    ImGui::SetCursorPos({20, 20});
    button("choice/first", "First");
    ImGui::SetNextWindowPos({10, 10});
    ImGui::Begin("dialog", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize);
    button("answer", "Answer");
    ImGui::End();
  });
  EXPECT_EQ(fit_watch().overlap(), "");
}

}  // namespace
}  // namespace fit_test
