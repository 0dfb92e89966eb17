#include "gui/session/compare_technique.h"

#include <fmt/format.h>

#include "scene/load.h"

namespace ps::gui {

void compare_technique(Session& session, const Technique& technique, const TechniqueChoice& choice) {
  const auto shown = session.shown_technique();
  if (shown && &technique_table()[shown->technique].choices[shown->choice] == &choice) return leave_technique(session);
  const std::string before = session.scene().title;
  const std::string name = session.document().scene_name;
  session.edit(technique_command(technique, choice),
               [&](Document& document) { document = with_technique(document, technique, choice, load_scene); });
  if (session.document().scene_name != name)
    session.say(Message::Kind::information,
                fmt::format("{} cannot show this, so {} is open. Back leads back.", before, session.scene().title));
}

void leave_technique(Session& session) {
  session.edit("back from the comparison", [](Document& document) { document = without_technique(document); });
}

std::string technique_command(const Technique& technique, const TechniqueChoice& choice) {
  if (technique.choices.size() == 1) return fmt::format("{}: with and without", technique.label);
  return fmt::format("{}: {} in B", technique.label, choice.label);
}

}  // namespace ps::gui
