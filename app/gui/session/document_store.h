#pragma once
#include <functional>
#include <optional>
#include <string>

#include "document/document.h"
#include "document/history.h"
#include "document/technique.h"
#include "gui/session/message_list.h"

namespace ps::gui {

/// Where a document that was loaded comes from: a scene that was opened, a permalink, which also stores how the window
/// is divided, or the open scene's file, read again.
enum class LoadReason { open, permalink, reload };

/// The document with its history: the one place where either is changed. What cannot be changed as asked, and what undo
/// took back, is said as a message.
class DocumentStore {
 public:
  virtual ~DocumentStore() = default;
  DocumentStore(const DocumentStore&) = delete;
  DocumentStore& operator=(const DocumentStore&) = delete;

  // --- what there is ---
  bool has_scene() const { return history_.has_value(); }
  const Document& document() const { return document_; }
  const Scene& scene() const { return document_.scene; }
  const SceneTraits& traits() const { return traits_; }
  const Settings& settings(Side side) const { return side_of(document_, side).settings; }
  ShownChannel shown(Side side) const { return side_of(document_, side).show; }
  View view() const { return view_of(document_); }
  /// The comparison of a technique that A and B are; looked up anew only after a change.
  std::optional<ShownTechnique> shown_technique() const;
  /// The picked pixel; nullopt where none is, or it is outside of the picture.
  std::optional<Vec2i> pixel() const;
  const std::optional<TileRect>& region() const { return document_.view.region; }

  // --- changing it; `what` names the step in the history ---
  /// Makes one step. An InputError from `apply` becomes a message and leaves the document as it was. Steps with the
  /// same `drag` (not empty) in a row become one, until end_drag().
  void edit(const std::string& what, const std::string& drag, const std::function<void(Document&)>& apply);
  void edit(const std::string& what, const std::function<void(Document&)>& apply) { edit(what, {}, apply); }
  void end_drag();
  /// Runs `save`, which answers what it has saved, and shows that, or why it could not: an InputError becomes a
  /// message.
  void say_saved(const std::function<std::string()>& save);
  /// Changes one property of the scene. Changes of the same one in a row are one step until end_drag().
  void edit_property(const std::string& label, const SceneEdit& change);
  /// Takes back what the steps with this `drag` have changed, which leaves no step to undo or redo. Answers whether
  /// there was something.
  bool cancel_drag(const std::string& drag);
  void set_settings(Side side, const Settings& settings, const std::string& what, const std::string& drag = {});
  /// Moves around without leaving a step: zoom, compare mode, layout, the picked pixel. Undo keeps these as they are.
  void navigate(const std::function<void(Document&)>& apply);
  void set_pixel(std::optional<Vec2i> pixel);
  /// Only these pixels are rendered (CGPP 15.4.4); absent = all. A new scene shows all again.
  void set_region(std::optional<TileRect> region);

  // --- history ---
  bool can_undo() const { return history_ && history_->can_undo(); }
  bool can_redo() const { return history_ && history_->can_redo(); }
  /// What undo and redo would take back or do again.
  std::string undo_label() const;
  std::string redo_label() const;
  void undo();
  void redo();
  /// Every step there is, oldest first; nullptr before the first scene.
  const History* history() const { return history_ ? &*history_ : nullptr; }
  /// Goes to a step as undo and redo do. Without effect where there is none.
  void go_to_entry(std::size_t place);

  /// Permalink of the document; made anew only after a change.
  const std::string& permalink() const;
  /// Grows with every change of the document. What follows from the document alone is up to date as long as this is
  /// the number that it was made for.
  std::uint64_t revision() const { return revision_; }
  /// Counts the changes that are steps of the history: edits, undo and redo, new scenes. All steps of one drag are one.
  std::uint64_t change() const { return change_; }

  MessageList& messages() { return messages_; }
  const MessageList& messages() const { return messages_; }
  void say(Message::Kind kind, std::string text) { messages_.say({kind, std::move(text)}); }

 protected:
  DocumentStore() = default;
  /// Shows a document that was loaded, as one step of the history. Steps with the same `drag` (not empty) are one.
  void take_up(Document document, LoadReason reason, const std::string& drag = {});
  /// The scene of that name as it was loaded last; an empty one where the history has none.
  Scene earlier_scene(const std::string& name) const;
  /// Notes that something was changed by change_silently().
  void changed() { ++revision_; }
  /// The document, for what follows from it: no step, and no call of settle(). Ends in changed().
  Document& change_silently() { return document_; }

  /// After a change: what belonged to the pixel, or to the models, that were there before goes, unless the change
  /// itself brought it.
  virtual void settle(const Document& before, Document& document) = 0;
  /// After a step: the document may show another scene or another picture file.
  virtual void step_taken() = 0;

 private:
  void say_step(const std::string& did, const std::string& step);
  void document_changed();
  /// Shows the history's current entry where the user is now.
  void show_entry();

  Document document_;               // with where the user is now
  std::optional<History> history_;  // empty before the first scene
  SceneTraits traits_;
  MessageList messages_;
  std::uint64_t revision_ = 0, change_ = 0;
  mutable std::optional<std::uint64_t> linked_revision_;  // that link_ was made for
  mutable std::string link_;
  mutable std::optional<std::uint64_t> technique_revision_;  // that technique_ was found for
  mutable std::optional<ShownTechnique> technique_;
};

}  // namespace ps::gui
