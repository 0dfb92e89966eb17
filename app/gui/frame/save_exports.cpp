#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/kept_inputs.h"
#include "base/spelling.h"
#include "document/document_provenance.h"
#include "gui/frame/app.h"
#include "inspect/story_json.h"
#include "inspect/story_markdown.h"
#include "scene/load.h"

namespace ps::gui {

/// Writes the story of the picked pixel in the form that the file's extension names: md, csv or json.
void App::save_story_as(std::filesystem::path path) {
  const auto story = session_.story(inspected_side(session_));
  if (!story) return;
  if (path.extension().empty()) path += ".md";
  const std::string extension = path.extension().string();
  const Provenance made = document_provenance(session_.document(), inspected_side(session_));
  try {
    require_no_input(path, files_of(session_.document().base));
    if (extension == ".csv")
      write_file_atomically(path, story_csv(*story, session_.scene(), made));
    else if (extension == ".json")
      write_file_atomically(path, story_json(*story, session_.scene(), session_.view(), made));
    else if (extension == ".md")
      write_file_atomically(path, story_markdown(*story, session_.scene(), session_.view(), made));
    else
      throw InputError(fmt::format("{}: found extension '{}', expected md, csv or json", path.string(), extension));
    session_.say(Message::Kind::information, fmt::format("Saved {}.", path.string()));
  } catch (const InputError& error) {
    session_.say(Message::Kind::error, error.what());
  }
}

/// Puts a command for a shell on the clipboard and shows how it begins.
void App::copy_command(const std::string& command) {
  shell_.set_clipboard(command);
  session_.say(Message::Kind::information, "On the clipboard: " + shown_start(command));
}

void App::save_drawing(std::filesystem::path path, const std::string& svg) {
  if (svg.empty()) return session_.say(Message::Kind::warning, "There is nothing to draw yet.");
  if (path.extension().empty()) path += ".svg";
  try {
    require_no_input(path, files_of(session_.document().base));
    write_file_atomically(path,
                          svg_with_provenance(svg, document_provenance(session_.document(), inspected_side(session_))));
    session_.say(Message::Kind::information, fmt::format("Saved {}.", path.string()));
  } catch (const InputError& error) {
    session_.say(Message::Kind::error, error.what());
  }
}

}  // namespace ps::gui
