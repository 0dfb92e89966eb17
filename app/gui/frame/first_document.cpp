#include "gui/frame/first_document.h"

#include <fmt/format.h>

#include <utility>

#include "base/check.h"
#include "base/failure_text.h"
#include "document/permalink_file.h"
#include "engine/lesson.h"
#include "options/option.h"
#include "scene/load.h"

namespace ps::gui {
namespace {

constexpr const char* first_scene = "cgfs/reflections";

}  // namespace

Document first_document(const AppOptions& options) {
  if (!options.lesson.empty()) load_lesson(parse_lesson_place(options.lesson).lesson);
  Document document;
  std::string link = options.permalink;
  if (link.empty() && !options.scene.empty()) link = permalink_in_file(options.scene).value_or("");
  if (!link.empty()) {
    document = linked_document(link);
  } else {
    const std::string scene = options.scene.empty() ? first_scene : options.scene;
    document = open_document(scene, load_scene(scene));
  }
  for (const auto& assignment : options.set) parse_assignment(assignment, document.a.settings);
  for (const auto& assignment : options.set_b) parse_assignment(assignment, document.b.settings);
  const View before = view_of(document);
  if (options.width > 0) document.view.width = options.width;
  if (options.height > 0) document.view.height = options.height;
  // The start pixel is meant for the scene's own size.
  const View after = view_of(document);
  if (document.pixel.x >= 0)
    document.pixel = {document.pixel.x * after.width / before.width, document.pixel.y * after.height / before.height};
  fit_region(document);
  return document;
}

bool nothing_asked(const AppOptions& options) {
  return options.scene.empty() && options.permalink.empty() && options.lesson.empty();
}

std::optional<Document> restored_document(Autosave& autosave, Session& session, std::vector<Message>& words) {
  std::optional<Document> document;
  std::string others;
  for (const LeftBehind& left : autosave.take_left_behind()) {
    std::string problem = left.problem;
    if (problem.empty() && left.ended_at_once) {
      session.loader().note_recent(left.file.string());
      words.push_back({Message::Kind::warning,
                       "Pixelscope ended right after it had restored a screen, which is therefore left out; Scene, "
                       "Recent offers it: " +
                           left.file.string()});
      continue;
    }
    if (problem.empty() && document) {
      session.loader().note_recent(left.file.string());
      others += (others.empty() ? "" : ", ") + left.file.string();
      continue;
    }
    try {
      AppOptions as_left;
      as_left.permalink = left.text;
      if (problem.empty()) document = first_document(as_left);
    } catch (const std::exception& error) {  // InputError, also where a scene has gone; no memory
      problem = failure_text(error);
    }
    if (problem.empty()) {
      autosave.restore(left);
      words.push_back({Message::Kind::information,
                       left.ended_from_outside
                           ? "This was open when Pixelscope was ended from outside, as by a log-out or a shutdown."
                           : "Pixelscope did not end properly the last time. This was open then."});
    } else {
      words.push_back({Message::Kind::warning,
                       fmt::format("What was open when Pixelscope ended cannot be shown: {}. It is kept as {}.",
                                   problem, left.file.string())});
    }
  }
  if (!others.empty())
    words.push_back({Message::Kind::warning, "More was open in other windows; Scene, Recent offers it: " + others});
  return document;
}

}  // namespace ps::gui
