#pragma once
#include <optional>
#include <string>
#include <vector>

#include "gui/panels/lesson/lesson_claims.h"

namespace ps::gui {

/// A button of a claim, with what it puts on the screen.
struct ClaimButton {
  const char *name, *label;
  ClaimShown leads_to;
};

/// The line below a claim's text, as it is with what is known now.
struct ClaimLayout {
  std::optional<bool> holds;
  std::string lines;  ///< the sentence, broken
  std::vector<ClaimButton> buttons;
  float width = 0, height = 0, text_height = 0;
  bool one_row = false;  ///< the buttons are beside the sentence
};
ClaimLayout lay_out_claim(const LessonClaims& claims, std::size_t claim, float width);

/// What a claim measures, whether it holds, and buttons that break it and mend it again. Draws at the cursor.
void claim_line(Session& session, LessonClaims& claims, std::size_t claim, const ClaimLayout& layout);

}  // namespace ps::gui
