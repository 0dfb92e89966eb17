// Whatever a lesson names in bold can be clicked.
#include <gtest/gtest.h>

#include "engine/lesson.h"
#include "gui/panels/lesson/text_view.h"

namespace lesson_names_test {
namespace {

TEST(LessonText, EveryNameInBoldLeadsSomewhere) {
  int names = 0;
  for (const std::string& name : ps::lesson_names())
    for (const ps::LessonStep& step : ps::load_lesson(name).steps)
      for (const auto* blocks : {&step.blocks, &step.hints})
        for (const ps::TextBlock& block : *blocks)
          for (const ps::TextSpan& span : block.spans) {
            if (span.style != ps::TextStyle::strong) continue;
            ++names;
            EXPECT_TRUE(ps::gui::target_of(span)) << name << ", " << step.title << ": " << span.text;
          }
  EXPECT_GT(names, 15);
}

}  // namespace
}  // namespace lesson_names_test
