#pragma once
#include <optional>
#include <string>
#include <vector>

#include "document/document.h"
#include "gui/session/autosave.h"
#include "gui/session/session.h"

namespace ps::gui {

/// The document that the window shows first.
struct AppOptions {
  std::string scene;                    ///< path or built-in name; empty = the first-start scene
  std::string permalink;                ///< instead of a scene
  std::string lesson;                   ///< folder name of a lesson to begin
  std::vector<std::string> set, set_b;  ///< "key=value" for A and for B
  int width = 0, height = 0;            ///< picture size; 0 = the scene's own
  bool remember = true;                 ///< restore after a crash; off for scripts
};

/// The document that the options ask for. Throws InputError for a scene, lesson, option or permalink that is not
/// to be had.
Document first_document(const AppOptions& options);

/// No argument says what to show: the window may restore what was open when the program did not end properly.
bool nothing_asked(const AppOptions& options);

/// The newest of what programs that did not end properly had open, if it can be read. All others stay on disk, named
/// and offered, and so does one that was restored before and ended its program at once. `words` gets what the user
/// should read about it.
std::optional<Document> restored_document(Autosave& autosave, Session& session, std::vector<Message>& words);

}  // namespace ps::gui
