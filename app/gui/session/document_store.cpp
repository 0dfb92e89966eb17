#include "gui/session/document_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "document/permalink.h"

namespace ps::gui {
namespace {

/// The picked pixel of `from` where a picture of the size of `to` has it.
Vec2i same_place(const Document& from, const Document& to) {
  const View old = view_of(from), now = view_of(to);
  if (from.pixel.x < 0 || (old.width == now.width && old.height == now.height)) return from.pixel;
  return {from.pixel.x * now.width / old.width, from.pixel.y * now.height / old.height};
}

/// Where the user is, as opposed to what was changed: undo leaves it alone.
void keep_place(const Document& from, Document& to) {
  const auto camera = to.view.camera;
  const int width = to.view.width, height = to.view.height;
  to.view = from.view;
  to.view.camera = camera;
  to.view.width = width;
  to.view.height = height;
  to.pixel = same_place(from, to);
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

std::optional<Vec2i> DocumentStore::pixel() const {
  if (!has_scene() || !inside(document_.pixel, view())) return {};
  return document_.pixel;
}

void DocumentStore::edit(const std::string& what, const std::string& drag,
                         const std::function<void(Document&)>& apply) {
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
  settle(before, document_);
  document_changed();
}

void DocumentStore::say_saved(const std::function<std::string()>& save) {
  try {
    say(Message::Kind::information, save());
  } catch (const InputError& error) {
    say(Message::Kind::error, error.what());
  }
}

void DocumentStore::edit_property(const std::string& label, const SceneEdit& change) {
  edit(label, change.path, [&](Document& document) { edit_scene(document, change); });
}

void DocumentStore::end_drag() {
  if (history_) history_->end_drag();
}

bool DocumentStore::cancel_drag(const std::string& drag) {
  if (!history_ || !history_->cancel_drag(drag)) return false;
  show_entry();
  return true;
}

void DocumentStore::set_settings(Side side, const Settings& settings, const std::string& what,
                                 const std::string& drag) {
  edit(what, drag, [&](Document& document) { side_of(document, side).settings = settings; });
}

void DocumentStore::navigate(const std::function<void(Document&)>& apply) {
  if (!has_scene()) return;
  const Document before = document_;
  apply(document_);
  settle(before, document_);
  changed();
}

void DocumentStore::set_region(std::optional<TileRect> region) {
  navigate([&](Document& document) { document.view.region = region; });
}

void DocumentStore::set_pixel(std::optional<Vec2i> pixel) {
  navigate([&](Document& document) { document.pixel = pixel.value_or(Vec2i(-1, -1)); });
}

std::string DocumentStore::undo_label() const { return can_undo() ? history_->entries()[history_->place()].label : ""; }
std::string DocumentStore::redo_label() const {
  return can_redo() ? history_->entries()[history_->place() + 1].label : "";
}

void DocumentStore::undo() {
  if (!can_undo()) return;
  say_step("Undid: ", undo_label());
  go_to_entry(history_->place() - 1);
}

void DocumentStore::redo() {
  if (!can_redo()) return;
  say_step("Redid: ", redo_label());
  go_to_entry(history_->place() + 1);
}

/// In place of the step before, so that many steps are one line.
void DocumentStore::say_step(const std::string& did, const std::string& step) {
  messages_.remove([](const Message& message) { return message.about == Message::About::step; });
  messages_.say({Message::Kind::information, did + step, Message::About::step});
}

void DocumentStore::go_to_entry(std::size_t place) {
  if (!history_ || place >= history_->entries().size()) return;
  history_->go_to(place);
  show_entry();
}

void DocumentStore::show_entry() {
  ++change_;
  const Document before = std::exchange(document_, history_->current());
  keep_place(before, document_);
  fit_region(document_);
  settle(before, document_);
  document_changed();
}

/// The scene of that name as it was loaded last, if the history has it: what the file still holds need not be kept
/// twice.
Scene DocumentStore::earlier_scene(const std::string& name) const {
  if (!history_) return {};
  const auto& entries = history_->entries();
  const auto found = std::find_if(entries.rbegin(), entries.rend(),
                                  [&](const History::Entry& entry) { return entry.document.scene_name == name; });
  return found == entries.rend() ? Scene{} : found->document.base;
}

std::optional<ShownTechnique> DocumentStore::shown_technique() const {
  if (std::exchange(technique_revision_, revision_) != revision_) technique_ = ps::shown_technique(document_, traits_);
  return technique_;
}

const std::string& DocumentStore::permalink() const {
  if (linked_revision_ != revision_) {
    link_ = has_scene() ? ps::permalink(document_) : "";
    linked_revision_ = revision_;
  }
  return link_;
}

void DocumentStore::take_up(Document document, LoadReason reason, const std::string& drag) {
  switch (reason) {
  case LoadReason::open:
  case LoadReason::permalink:  // stores how the window is divided, too
    if (has_scene() && reason == LoadReason::open) {
      document.mode = document_.mode;
      document.layout = document_.layout;
      document.story = carried_over(document_.story, false);
    }
    messages_.remove([](const Message& message) {
      return message.kind != Message::Kind::error || message.about == Message::About::scene;
    });
    break;
  case LoadReason::reload:
    keep_place(document_, document);
    document.picture_b = document_.picture_b;
    fit_region(document);
    keep_pin(document_, document);
    // What was wrong with the file has been mended.
    messages_.remove([&](const Message& message) {
      return message.kind == Message::Kind::warning ||
             (message.about == Message::About::scene && message.file == document.scene_name);
    });
    break;
  }
  const Document before = std::exchange(document_, document);
  if (reason == LoadReason::reload) settle(before, document_);
  if (const auto& warnings = document_.scene.warnings; !warnings.empty()) {
    const std::size_t others = warnings.size() - 1;
    say(Message::Kind::warning,
        others == 0 ? warnings.front()
                    : fmt::format("{} ({} more such note{})", warnings.front(), others, others == 1 ? "" : "s"));
  }
  if (!history_)
    history_.emplace(std::move(document), "start");
  else
    history_->push(std::move(document), reason == LoadReason::reload ? "reload" : "open " + document_.scene_name, drag);
  ++change_;
  document_changed();
}

void DocumentStore::document_changed() {
  changed();
  traits_ = scene_traits(document_.scene);
  step_taken();
}

}  // namespace ps::gui
