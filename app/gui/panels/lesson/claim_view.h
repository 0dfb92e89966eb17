#pragma once
#include "gui/panels/lesson/lesson_claims.h"

namespace ps::gui {

/// Height of the line below a claim's text, in this width.
float claim_line_height(const LessonClaims& claims, std::size_t claim, float width);

/// What a claim measures, whether it holds, and buttons that break it and mend it again. Draws at the cursor.
void claim_line(Session& session, LessonClaims& claims, std::size_t claim, float width);

}  // namespace ps::gui
