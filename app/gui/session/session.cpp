#include "gui/session/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/archived_file.h"
#include "base/check.h"
#include "document/permalink_file.h"
#include "engine/lesson.h"
#include "engine/lesson_place.h"
#include "scene/load.h"
#include "scene/share_content.h"

namespace ps::gui {
namespace {

constexpr const char* text_on_clipboard = "permalink";  // the name of a document that comes from no file

}  // namespace

void Session::update() {
  if (auto loaded = loader_.take()) take_loaded(std::move(*loaded));
  follow_files();
  work_.take_news();
  if (!has_scene()) return;
  request_work();
  for (const Side side : both_sides)
    if (events_.follow({change_silently(), side, inspected_side(*this), story(side), work_.inspector(side).busy()}))
      changed();
}

void Session::request_changed() {
  if (requested_ != revision() && has_scene()) request_work();
}

std::shared_ptr<const PixelStory> Session::story(Side side) const {
  return pixel() ? work_.inspector(side).story_of(scene().name) : nullptr;
}

void Session::draw_again() {
  work_.draw_again();
  changed();
}

void Session::start(Document document, const std::string& drag) { take(std::move(document), LoadReason::open, drag); }

void Session::open(const std::string& path_or_name) {
  if (const std::string folder = lesson_folder_at(path_or_name); !folder.empty()) {
    loader_.load(
        folder, [folder, now = document()] { return lesson_document(load_lesson(folder), 0, now); },
        LoadReason::permalink);
    return;
  }
  try {
    if (const auto link = permalink_in_file(path_or_name)) return open_permalink(*link, path_or_name);
  } catch (const InputError& error) {
    return take_loaded(failed_load(path_or_name, error));
  }
  if (is_picture_file(path_or_name)) return open_picture_b(path_or_name);
  loader_.load(
      path_or_name,
      [path_or_name, earlier = earlier_scene(path_or_name)] {
        return open_document(path_or_name, share_content(load_scene(path_or_name), earlier));
      },
      LoadReason::open);
}

void Session::open_permalink(const std::string& text, const std::string& file) {
  loader_.load(
      file.empty() ? text_on_clipboard : file, [text] { return linked_document(text); }, LoadReason::permalink);
}

std::string Session::failed_scene() const {
  const auto& all = messages().all();
  const auto failed = std::find_if(all.rbegin(), all.rend(), [](const Message& message) {
    return message.kind == Message::Kind::error && message.about == Message::About::scene;
  });
  return failed == all.rend() ? std::string() : failed->file;
}

void Session::reload() {
  if (const std::string failed = failed_scene(); !failed.empty() && failed != document().scene_name)
    return open(failed);
  reload_scene();
}

void Session::reload_scene() {
  if (!has_scene()) return;
  loader_.load(
      document().scene_name,
      [document = document()]() mutable {
        attach_scene(document, share_content(load_scene(document.scene_name), document.base));
        return document;
      },
      LoadReason::reload);
}

void Session::follow_files() {
  const auto changed = loader_.take_changed();
  if (changed.empty()) return;
  const auto own = has_scene() ? files_of(document().base) : std::vector<std::string>();
  const bool of_scene = std::find_first_of(changed.begin(), changed.end(), own.begin(), own.end()) != changed.end();
  if (of_scene)
    reload_scene();
  else
    reload();
}

void Session::watch_files() {
  std::vector<std::filesystem::path> files;
  if (has_scene())
    for (const auto& file : files_of(document().base)) files.push_back(file_on_disk(file));
  if (!failed_scene().empty())
    for (const auto& file : failed_files_) files.push_back(file_on_disk(file));
  loader_.watch(files);
}

void Session::take_loaded(Loaded loaded) {
  if (loaded.document) return take(std::move(*loaded.document), loaded.reason);
  // A file that could not be opened is meant by a reload, and opened once it is mended, until its message goes.
  const bool is_file = loaded.name != text_on_clipboard;
  if (is_file)
    messages().remove(
        [&](const Message& message) { return message.about == Message::About::scene && message.file == loaded.name; });
  std::string text = loaded.error;
  if (has_scene()) text.insert(std::min(text.find('\n'), text.size()), " (the previous scene stays open)");
  messages().say({Message::Kind::error, text, Message::About::scene, is_file ? loaded.name : ""});
  if (!is_file) return;
  failed_files_ = {loaded.name};
  if (!loaded.error_file.empty()) failed_files_.emplace_back(loaded.error_file);
  watch_files();
}

void Session::take(Document document, LoadReason reason, const std::string& drag) {
  if (reason != LoadReason::reload) {
    loader_.note_recent(is_own_lesson(document.lesson) ? document.lesson : document.scene_name);
    events_.await_stories();
  }
  watched_.clear();  // a reload may have brought other files
  take_up(std::move(document), reason, drag);
}

void Session::step_taken() {
  follow_picture_b();
  if (watched_ == document().scene_name) return;
  watched_ = document().scene_name;
  watch_files();
}

void Session::request_work() {
  requested_ = revision();
  if (picture_b_) {
    const Vec2i size{picture_b_->levels.width(), picture_b_->levels.height()};
    if (size != Vec2i(view().width, view().height))
      give_up_picture_b(fmt::format("{} has {} x {} pixels, where the picture has {} x {}.", picture_b_->path, size.x,
                                    size.y, view().width, view().height));
  }
  work_.request(document(), traits(), !picture_b_);
}

Side inspected_side(const Session& session) { return session.picture_b() ? Side::a : session.document().picked; }

}  // namespace ps::gui
