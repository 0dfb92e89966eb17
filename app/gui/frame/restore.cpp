#include <fmt/format.h>

#include "base/failure_text.h"
#include "gui/frame/app.h"

namespace ps::gui {

/// The newest of what programs that did not end properly had open, if it can be read. All others stay on disk, named
/// and offered.
std::optional<Document> App::restored(std::vector<Message>& words) {
  std::optional<Document> document;
  std::string others;
  for (const LeftBehind& session : autosave_.take_left_behind()) {
    std::string problem = session.problem;
    if (problem.empty() && document) {
      session_.note_recent(session.file.string());
      others += (others.empty() ? "" : ", ") + session.file.string();
      continue;
    }
    try {
      AppOptions as_left;
      as_left.permalink = session.text;
      if (problem.empty()) document = first_document(as_left);
    } catch (const std::exception& error) {  // InputError, also where a scene has gone; no memory
      problem = failure_text(error);
    }
    if (problem.empty()) {
      autosave_.forget(session);
      words.push_back(
          {Message::Kind::information, "Pixelscope did not end properly the last time. This was open then."});
    } else {
      words.push_back(
          {Message::Kind::warning,
           fmt::format("What was open when Pixelscope did not end properly cannot be shown: {}. It is kept as {}.",
                       problem, session.file.string())});
    }
  }
  if (!others.empty())
    words.push_back({Message::Kind::warning, "More was open in other windows; Scene, Recent offers it: " + others});
  return document;
}

}  // namespace ps::gui
