#pragma once
#include "document/technique.h"
#include "gui/session/session.h"

namespace ps::gui {

/// Shows the comparison as one step of the history; what is shown already is left again. Where the open scene cannot
/// show it, one that can opens, and a message says so.
void compare_technique(Session& session, const Technique& technique, const TechniqueChoice& choice);

/// The way back from all comparisons in a row, as one step.
void leave_technique(Session& session);

/// "Shadows: with and without", "Shading: Gouraud in B".
std::string technique_command(const Technique& technique, const TechniqueChoice& choice);

}  // namespace ps::gui
