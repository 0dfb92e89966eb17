#pragma once
#include <optional>
#include <string>

#include "gui/panels/lesson/text_view.h"

namespace ps::gui {

/// The glossary over the window.
struct GlossaryState {
  bool open = false, just_opened = false;
  std::string search;
  std::string term;    ///< that is marked: what was followed here
  int scroll_for = 0;  ///< frames in which the marked term is still to be brought into view
};

/// Opens it at this term, or at its begin if the term is empty.
void open_glossary(GlossaryState& state, const std::string& term = {});

/// Draws it while it is open. Answers a link of a definition that leads out of it, which also closes it.
std::optional<LinkTarget> glossary_sheet(Session& session, GlossaryState& state);

}  // namespace ps::gui
