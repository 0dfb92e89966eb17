#pragma once
#include <optional>
#include <string>
#include <vector>

#include "gui/panels/lesson/text_layout.h"
#include "gui/panels/messages.h"
#include "gui/session/session.h"

namespace ps::gui {

/// Where a span of the text leads: its link, or for a name in bold the control of that name. nullopt for other text.
std::optional<LinkTarget> target_of(const TextSpan& span);

/// Draws a line at the cursor, with its controls, and moves on below it. Answers the link that was clicked. Links have
/// the names "link/" and where they lead: "link/option:shading", "link/panel:chart", "link/step:2".
std::optional<LinkTarget> draw_line(Session& session, const TextLine& line);

/// Lines below one another from the cursor on, with the gaps between them, as one item of this width.
std::optional<LinkTarget> draw_text_lines(Session& session, const std::vector<TextLine>& lines, float width);

}  // namespace ps::gui
