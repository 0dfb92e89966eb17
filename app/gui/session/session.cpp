#include "gui/session/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>
#include <utility>

#include "base/check.h"
#include "base/failure_text.h"
#include "document/permalink.h"
#include "document/permalink_file.h"
#include "engine/lesson.h"
#include "engine/lesson_place.h"
#include "scene/load.h"
#include "scene/share_content.h"

namespace ps::gui {
namespace {

constexpr std::size_t recent_limit = 10;
constexpr const char* recent_key = "session/recent";

/// Where the user is, as opposed to what was changed: undo leaves it alone.
void keep_place(const Document& from, Document& to) {
  const auto camera = to.view.camera;
  const int width = to.view.width, height = to.view.height;
  to.view = from.view;
  to.view.camera = camera;
  to.view.width = width;
  to.view.height = height;
  to.pixel = from.pixel;
  to.picked = from.picked;
  to.events = from.events;
  to.story = from.scene_name == to.scene_name ? from.story : carried_over(from.story, false);
  to.compare = from.compare;
  to.split = from.split;
  to.heat_range = from.heat_range;
  if (from.lesson == to.lesson && from.step == to.step) {  // a step brings its own
    to.a.slow_motion = from.a.slow_motion;
    to.b.slow_motion = from.b.slow_motion;
  }
  to.difference_gain = from.difference_gain;
  to.mode = from.mode;
  to.layout = from.layout;
}

/// A pin stays where it still has a place in the scene.
void keep_pin(const Document& from, Document& to) {
  if (!from.pin) return;
  try {
    pinned_scene(*from.pin, to.base);
    to.pin = from.pin;
  } catch (const InputError&) {
    // The file has changed so much that there is nothing to compare with.
  }
}

bool inside(Vec2i pixel, const View& view) {
  return pixel.x >= 0 && pixel.y >= 0 && pixel.x < view.width && pixel.y < view.height;
}

}  // namespace

Session::Session(SessionHost host) : host_(std::move(host)), watch_(host_.wake) {
  for (const Side side : both_sides) {
    renderers_[index_of(side)] = std::make_unique<RenderWorker>(prepared_, host_.wake);
    inspectors_[index_of(side)] = std::make_unique<InspectWorker>(prepared_, host_.wake);
  }
  if (host_.remembered) {
    std::istringstream lines(host_.remembered(recent_key));
    for (std::string line; std::getline(lines, line);)
      if (!line.empty() && recent_.size() < recent_limit) recent_.push_back(line);
  }
}

Session::~Session() = default;

bool Session::update() {
  const bool arrived = take_loaded();
  if (watch_.take_changed()) reload();
  for (const auto& inspector : inspectors_) inspector->take_news();
  if (has_scene()) {
    request_work();
    for (const Side side : both_sides) follow_story(side);
  }
  return arrived;
}

void Session::changed() {
  changed_ = true;
  ++revision_;
}

void Session::request_changed() {
  if (changed_ && has_scene()) request_work();
}

std::optional<Vec2i> Session::pixel() const {
  if (!has_scene() || !inside(document_.pixel, view())) return {};
  return document_.pixel;
}

std::shared_ptr<const PixelStory> Session::story(Side side) const {
  const auto wanted = pixel();
  if (!wanted) return nullptr;
  return inspectors_[index_of(side)]->story_of(document_.scene.name);
}

bool Session::rendering() const {
  return std::any_of(renderers_.begin(), renderers_.end(), [](const auto& renderer) {
    const RenderState state = renderer->status().state;
    return state == RenderState::coarse || state == RenderState::full;
  });
}

bool Session::busy() const {
  return loading() ||
         std::any_of(renderers_.begin(), renderers_.end(), [](const auto& renderer) { return renderer->busy(); }) ||
         std::any_of(inspectors_.begin(), inspectors_.end(), [](const auto& inspector) { return inspector->busy(); });
}

bool Session::has_news() const {
  {
    const std::lock_guard lock(loaded_mutex_);
    if (loaded_) return true;
  }
  return std::any_of(both_sides.begin(), both_sides.end(), [&](Side side) {
    return renderers_[index_of(side)]->has_news() || inspectors_[index_of(side)]->has_news();
  });
}

void Session::edit(const std::string& what, const std::string& drag, const std::function<void(Document&)>& apply) {
  if (!has_scene()) return;
  Document changed = document_;
  try {
    apply(changed);
  } catch (const InputError& error) {
    say(Message::Kind::error, error.what());
    return;
  }
  if (changed == document_) return;
  const Document before = std::exchange(document_, changed);
  const auto newest = [&] { return std::pair(history_->place(), history_->entries().front().id); };
  const auto old = newest();
  history_->push(std::move(changed), what, drag);
  if (newest() != old) ++change_;  // else one more step of a drag
  settle(before);
  document_changed();
}

void Session::end_drag() {
  if (history_) history_->end_drag();
}

bool Session::cancel_drag(const std::string& drag) {
  if (!history_ || !history_->cancel_drag(drag)) return false;
  show_entry();
  return true;
}

void Session::set_settings(Side side, const Settings& settings, const std::string& what, const std::string& drag) {
  edit(what, drag, [&](Document& document) { side_of(document, side).settings = settings; });
}

void Session::navigate(const std::function<void(Document&)>& apply) {
  if (!has_scene()) return;
  const Document before = document_;
  apply(document_);
  settle(before);
  changed();
}

void Session::set_region(std::optional<TileRect> region) {
  navigate([&](Document& document) { document.view.region = region; });
}

void Session::set_pixel(std::optional<Vec2i> pixel) {
  navigate([&](Document& document) { document.pixel = pixel.value_or(Vec2i(-1, -1)); });
}

std::string Session::undo_label() const { return can_undo() ? history_->entries()[history_->place()].label : ""; }
std::string Session::redo_label() const { return can_redo() ? history_->entries()[history_->place() + 1].label : ""; }

void Session::undo() {
  if (!can_undo()) return;
  say_step("Undid: ", undo_label());
  go_to_entry(history_->place() - 1);
}

void Session::redo() {
  if (!can_redo()) return;
  say_step("Redid: ", redo_label());
  go_to_entry(history_->place() + 1);
}

/// In place of the step before, so that many steps are one line.
void Session::say_step(const std::string& did, const std::string& step) {
  std::erase_if(messages_, [](const Message& message) { return message.about == Message::About::step; });
  say({Message::Kind::information, did + step, Message::About::step});
}

void Session::go_to_entry(std::size_t place) {
  if (!history_ || place >= history_->entries().size()) return;
  history_->go_to(place);
  show_entry();
}

void Session::show_entry() {
  ++change_;
  const Document before = std::exchange(document_, history_->current());
  keep_place(before, document_);
  fit_region(document_);
  settle(before);
  document_changed();
}

void Session::start(Document document, const std::string& drag) { take_up(std::move(document), Reason::open, drag); }

void Session::open(const std::string& path_or_name) {
  if (const std::string folder = lesson_folder_at(path_or_name); !folder.empty()) {
    load(
        folder, [folder, now = document_] { return lesson_document(load_lesson(folder), 0, now); }, Reason::permalink);
    return;
  }
  try {
    if (const auto link = permalink_in_file(path_or_name)) return open_permalink(*link);
  } catch (const InputError& error) {
    say(Message::Kind::error, error.what());
    return;
  }
  if (is_picture_file(path_or_name)) return open_picture_b(path_or_name);
  load(
      path_or_name,
      [path_or_name, earlier = earlier_scene(path_or_name)] {
        return open_document(path_or_name, share_content(load_scene(path_or_name), earlier));
      },
      Reason::open);
}

/// The scene of that name as it was loaded last, if the history has it: what the file still holds need not be kept
/// twice.
Scene Session::earlier_scene(const std::string& name) const {
  if (!history_) return {};
  const auto& entries = history_->entries();
  const auto found = std::find_if(entries.rbegin(), entries.rend(),
                                  [&](const History::Entry& entry) { return entry.document.scene_name == name; });
  return found == entries.rend() ? Scene{} : found->document.base;
}

void Session::open_permalink(const std::string& text) {
  load(
      "permalink", [text] { return linked_document(text); }, Reason::permalink);
}

void Session::reload() {
  if (!has_scene()) return;
  load(
      document_.scene_name,
      [document = document_]() mutable {
        attach_scene(document, share_content(load_scene(document.scene_name), document.base));
        return document;
      },
      Reason::reload);
}

const std::string& Session::permalink() const {
  if (linked_revision_ != revision_) {
    link_ = has_scene() ? ps::permalink(document_) : "";
    linked_revision_ = revision_;
  }
  return link_;
}

void Session::cancel_loading() {
  loading_cancelled_ = true;
  loader_.cancel();
}

void Session::load(const std::string& name, std::function<Document()> make, Reason reason) {
  loading_name_ = name;
  loading_cancelled_ = false;
  loader_.start([this, name, make = std::move(make), reason](Progress& progress) {
    Loaded loaded;
    loaded.name = name;
    loaded.reason = reason;
    try {
      loaded.document = make();
    } catch (const std::exception& error) {
      loaded.error = failure_text(error);
    }
    progress.check();
    {
      const std::lock_guard lock(loaded_mutex_);
      loaded_ = std::move(loaded);
    }
    if (host_.wake) host_.wake();
  });
}

bool Session::take_loaded() {
  std::optional<Loaded> loaded;
  {
    const std::lock_guard lock(loaded_mutex_);
    loaded = std::exchange(loaded_, std::nullopt);
  }
  if (!loaded) return false;
  if (!loaded->document) {
    if (has_scene())
      say({Message::Kind::error, fmt::format("{} (the previous scene stays open)", loaded->error),
           Message::About::scene, loaded->name});
    else
      say(Message::Kind::error, loaded->error);
    return false;
  }
  take_up(std::move(*loaded->document), loaded->reason);
  return true;
}

void Session::take_up(Document document, Reason reason, const std::string& drag) {
  switch (reason) {
  case Reason::open:
  case Reason::permalink:  // stores how the window is divided, too
    if (has_scene() && reason == Reason::open) {
      document.mode = document_.mode;
      document.layout = document_.layout;
      document.story = carried_over(document_.story, false);
    }
    std::erase_if(messages_, [](const Message& message) {
      return message.kind != Message::Kind::error || message.about == Message::About::scene;
    });
    note_recent(is_own_lesson(document.lesson) ? document.lesson : document.scene_name);
    break;
  case Reason::reload:
    keep_place(document_, document);
    document.picture_b = document_.picture_b;
    fit_region(document);
    keep_pin(document_, document);
    // What was wrong with the file has been mended.
    std::erase_if(messages_, [&](const Message& message) {
      return message.kind == Message::Kind::warning ||
             (message.about == Message::About::scene && message.file == document.scene_name);
    });
    break;
  }
  const Document before = std::exchange(document_, document);
  if (reason == Reason::reload)
    settle(before);
  else
    awaited_ = {true, true};
  if (const auto& warnings = document_.scene.warnings; !warnings.empty()) {
    const std::size_t others = warnings.size() - 1;
    say(Message::Kind::warning,
        others == 0 ? warnings.front()
                    : fmt::format("{} ({} more such note{})", warnings.front(), others, others == 1 ? "" : "s"));
  }
  if (!history_)
    history_.emplace(std::move(document), "start");
  else
    history_->push(std::move(document), reason == Reason::reload ? "reload" : "open " + document_.scene_name, drag);
  ++change_;
  watched_.clear();  // a reload may have brought other files
  document_changed();
}

void Session::document_changed() {
  changed();
  traits_ = scene_traits(document_.scene);
  follow_picture_b();
  if (watched_ == document_.scene_name) return;
  watched_ = document_.scene_name;
  std::vector<std::filesystem::path> files;
  for (const auto& file : files_of(document_.base)) files.emplace_back(file);
  watch_.watch(files);
}

void Session::request_work() {
  changed_ = false;
  if (picture_b_) {
    const Vec2i size{picture_b_->levels.width(), picture_b_->levels.height()};
    renderers_[1]->cancel();
    if (size != Vec2i(view().width, view().height))
      give_up_picture_b(fmt::format("{} has {} x {} pixels, where the picture has {} x {}.", picture_b_->path, size.x,
                                    size.y, view().width, view().height));
  }
  const auto range = common_range();
  for (const Side side : both_sides) {
    PictureRequest request{document_.scene, view(), settings(side), shown(side), range_of(side, range), region()};
    if (side == Side::b && picture_b_) {
      inspectors_[1]->clear();
      continue;
    }
    if (const auto picked = pixel())
      inspectors_[index_of(side)]->request({request, *picked});
    else
      inspectors_[index_of(side)]->clear();
    request.slow = given_slow_motion(side_of(document_, side).slow_motion, settings(side), traits_, shown(side));
    renderers_[index_of(side)]->request(request);
  }
}

std::optional<ValueRange> Session::range_of(Side side, const std::optional<ValueRange>& common) const {
  const auto& asked = document_.heat_range;
  return asked && asked->channel == shown(side) ? asked->values : common;
}

/// Two heat maps of the same kind share one scale, so that equal colours mean equal numbers.
std::optional<ValueRange> Session::common_range() {
  if (shown(Side::a) != shown(Side::b) || shown(Side::a) == ShownChannel::colour) {
    ranged_ = {};
    return {};
  }
  const std::array results{renderers_[0]->result(), renderers_[1]->result()};
  if (results == ranged_) return range_;
  const auto needs = shown_channel(shown(Side::a)).needs;
  std::optional<ValueRange> common;
  for (const auto& result : results) {
    if (!result || (result->channels | needs) != result->channels) return range_;
    const auto range = channel_range(result->frame, shown(Side::a));
    if (!range) continue;
    common = common ? ValueRange{std::min(common->low, range->low), std::max(common->high, range->high)} : *range;
  }
  ranged_ = results;
  range_ = common;
  return range_;
}

void Session::note_recent(const std::string& name) {
  std::erase(recent_, name);
  recent_.insert(recent_.begin(), name);
  if (recent_.size() > recent_limit) recent_.resize(recent_limit);
  std::string lines;
  for (const auto& entry : recent_) lines += entry + '\n';
  if (host_.remember_lines) host_.remember_lines(recent_key, lines);
}

void Session::say(Message::Kind kind, std::string text) { say({kind, std::move(text)}); }

void Session::say(Message message) {
  const bool known =
      std::any_of(messages_.begin(), messages_.end(), [&](const Message& other) { return other.text == message.text; });
  if (!known) messages_.push_back(std::move(message));
}

bool Session::expire_messages(double now) {
  constexpr double long_enough = 6;  // seconds
  for (auto& message : messages_)
    if (message.since < 0) message.since = now;
  const auto passing = [](const Message& message) { return message.kind == Message::Kind::information; };
  std::erase_if(messages_,
                [&](const Message& message) { return passing(message) && now - message.since > long_enough; });
  return std::any_of(messages_.begin(), messages_.end(), passing);
}

void Session::dismiss(std::size_t index) {
  if (index < messages_.size()) messages_.erase(messages_.begin() + static_cast<std::ptrdiff_t>(index));
}

Side inspected_side(const Session& session) { return session.picture_b() ? Side::a : session.document().picked; }

}  // namespace ps::gui
