#pragma once
#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "document/document.h"
#include "document/history.h"
#include "gui/base/sides.h"
#include "gui/session/timed_pictures.h"
#include "gui/work/file_watch.h"
#include "gui/work/inspect_worker.h"
#include "gui/work/newest_job.h"
#include "gui/work/render_worker.h"
#include "image/stored_picture.h"

namespace ps::gui {

/// Something that the user should read.
struct Message {
  enum class Kind { information, warning, error } kind = Kind::information;
  std::string text;
  /// Subject of the message, with which it is replaced or removed.
  enum class About { nothing, step, scene, lesson } about = About::nothing;
  std::string file{};  ///< the scene or lesson that could not be loaded
  double since = -1;   ///< seconds on the window's clock when it was first seen; negative before
};

/// A picture from a file that is in B's place.
struct PictureFile {
  std::string path;
  StoredPicture stored;
  Image<Rgb8> levels;
};

/// What the session needs from the window around it. All may be empty.
struct SessionHost {
  std::function<void()> wake;  ///< from any thread: there is something new
  std::function<std::string(const std::string& key)> remembered;
  std::function<void(const std::string& key, std::string lines)> remember_lines;  ///< a list, one entry a line
};

/// All of the program that is not a widget: the document with its history, the scene files, and the work in the
/// background. For the window's thread; nothing here waits for work.
class Session {
 public:
  explicit Session(SessionHost host);
  ~Session();

  /// Once per frame: takes up loaded scenes and changed files, and asks for the renders and stories that the document
  /// needs now. Answers whether a new scene has arrived.
  bool update();
  /// At the end of a frame: asks for what the frame's changes need, so that work begins while the frame is drawn.
  void request_changed();

  // --- what there is ---
  bool has_scene() const { return history_.has_value(); }
  const Document& document() const { return document_; }
  const Scene& scene() const { return document_.scene; }
  const SceneTraits& traits() const { return traits_; }
  const Settings& settings(Side side) const { return side_of(document_, side).settings; }
  ShownChannel shown(Side side) const { return side_of(document_, side).show; }
  View view() const { return view_of(document_); }
  std::optional<Vec2i> pixel() const;
  RenderWorker& renderer(Side side) { return *renderers_[index_of(side)]; }
  InspectWorker& inspector(Side side) { return *inspectors_[index_of(side)]; }
  /// Renders and inspects everything anew, also what was prepared for it: a renderer has changed.
  void draw_again();
  /// How long pictures take, as far as that has been measured.
  TimedPictures& timed() { return timed_; }
  /// What has been built for the pictures.
  Prepared& prepared() { return *prepared_; }
  /// The same, for work that may end later than the session.
  std::shared_ptr<Prepared> shared_prepared() const { return prepared_; }
  /// The story of the picked pixel; nullptr while there is none.
  std::shared_ptr<const PixelStory> story(Side side) const;
  /// The selected event of that story; -1 while none is, or while the story that it belongs to is still to come.
  int selected_event(Side side) const;
  /// A picture is being rendered.
  bool rendering() const;
  /// Something is loading, rendering or being inspected.
  bool busy() const;
  /// Something has come that update() and RenderWorker::collect() have not taken up yet.
  bool has_news() const;

  // --- changing it; `what` names the step in the history ---
  /// Makes one step. An InputError from `apply` becomes a message and leaves the document as it was. Steps with the
  /// same `drag` (not empty) in a row become one, until end_drag().
  void edit(const std::string& what, const std::string& drag, const std::function<void(Document&)>& apply);
  void edit(const std::string& what, const std::function<void(Document&)>& apply) { edit(what, {}, apply); }
  void end_drag();
  /// Takes back what the steps with this `drag` have changed, which leaves nothing to undo or redo. Answers whether
  /// there was something.
  bool cancel_drag(const std::string& drag);
  void set_settings(Side side, const Settings& settings, const std::string& what, const std::string& drag = {});
  /// Moves around without leaving a step: zoom, compare mode, layout, the picked pixel. Undo keeps these as they are.
  void navigate(const std::function<void(Document&)>& apply);
  void set_pixel(std::optional<Vec2i> pixel);
  /// Only these pixels are rendered (CGPP 15.4.4); absent = all. A new scene shows all again.
  void set_region(std::optional<TileRect> region);
  const std::optional<TileRect>& region() const { return document_.view.region; }
  /// Puts a picture file (png, ppm, pfm) into B's place; the view takes its size. Errors become messages.
  void open_picture_b(const std::filesystem::path& path);
  /// B is rendered again.
  void close_picture_b();
  /// The file in B's place; nullptr while B is rendered.
  std::shared_ptr<const PictureFile> picture_b() const { return picture_b_; }
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

  // --- scenes ---
  /// Shows a document that is complete. The first thing to call. Documents with the same `drag` (not empty) in a row
  /// are one step of the history.
  void start(Document document, const std::string& drag = {});
  /// Loads in the background; the scene that is open stays until it has come, and for good if it cannot be read.
  void open(const std::string& path_or_name);
  void open_permalink(const std::string& text);
  void reload();
  bool loading() const { return !loading_cancelled_ && loader_.busy(); }
  /// What is being loaded.
  const std::string& loading_name() const { return loading_name_; }
  /// Drops what is being loaded; the open scene stays. Reading a file ends some time later, unseen.
  void cancel_loading();
  const std::vector<std::string>& recent() const { return recent_; }
  /// Puts a file in front of the recent ones, so that it is offered.
  void note_recent(const std::string& name);
  /// Permalink of the document; made anew only after a change.
  const std::string& permalink() const;
  /// Grows with every change of the document. What follows from the document alone is up to date as long as this is
  /// the number that it was made for.
  std::uint64_t revision() const { return revision_; }

  /// Counts the changes that are steps of the history: edits, undo and redo, new scenes. All steps of one drag are one.
  std::uint64_t change() const { return change_; }

  // --- messages ---
  const std::vector<Message>& messages() const { return messages_; }
  void say(Message::Kind kind, std::string text);
  void say(Message message);
  void dismiss(std::size_t index);
  /// Takes information away that has been seen for long enough; warnings and errors stay until they are dismissed.
  /// Answers whether some is still to go.
  bool expire_messages(double now);

 private:
  enum class Reason { open, permalink, reload };
  struct Loaded {
    std::string name;
    std::optional<Document> document;
    std::string error;
    Reason reason = Reason::open;
  };
  void say_step(const std::string& did, const std::string& step);
  Scene earlier_scene(const std::string& name) const;
  void load(const std::string& name, std::function<Document()> make, Reason reason);
  bool take_loaded();
  void take_up(Document document, Reason reason, const std::string& drag = {});
  /// Shows the history's current entry where the user is now.
  void show_entry();
  /// Brings what depends on the document's scene up to date.
  void document_changed();
  /// Reads the picture file that the document has in B's place, and drops one that it has no longer. One that cannot be
  /// read, or is not of the picture's size, becomes a message, and B is rendered.
  void follow_picture_b();
  void give_up_picture_b(const std::string& why);
  /// After a change: what belonged to the pixel, or to the models, that were there before goes, unless the change
  /// itself brought it.
  void settle(const Document& before);
  void changed();
  /// When a story comes, the selected event becomes the same event in it, after a change of options for example.
  void follow_story(Side side);
  void request_work();
  std::optional<ValueRange> common_range();
  /// Of a side's false colours: what was asked for, else what both have in common.
  std::optional<ValueRange> range_of(Side side, const std::optional<ValueRange>& common) const;

  SessionHost host_;
  std::shared_ptr<Prepared> prepared_ = std::make_shared<Prepared>();
  Document document_;               // with where the user is now
  std::optional<History> history_;  // empty before the first scene
  SceneTraits traits_;
  std::string watched_;                                        // name of the scene whose files are watched
  std::array<std::shared_ptr<const RenderResult>, 2> ranged_;  // results that range_ was made from
  std::optional<ValueRange> range_;
  TimedPictures timed_;
  std::shared_ptr<const PictureFile> picture_b_;
  std::vector<Message> messages_;
  std::vector<std::string> recent_;
  std::string loading_name_;
  bool loading_cancelled_ = false;
  bool changed_ = false;  // since work was last asked for
  std::uint64_t revision_ = 0, change_ = 0;
  mutable std::optional<std::uint64_t> linked_revision_;  // that link_ was made for
  mutable std::string link_;
  std::array<std::shared_ptr<const PixelStory>, 2> followed_;  // the stories that the selected events belong to
  std::array<bool, 2> awaited_{};  // the selected event belongs to a story that is still to come

  mutable std::mutex loaded_mutex_;
  std::optional<Loaded> loaded_;

  // Last, so that their threads end before what they use.
  std::array<std::unique_ptr<RenderWorker>, 2> renderers_;
  std::array<std::unique_ptr<InspectWorker>, 2> inspectors_;
  FileWatch watch_;
  NewestJob loader_;
};

/// Whether a file is a picture, by its name: these are never scenes.
bool is_picture_file(const std::string& path);

/// The side whose story is shown: the picked one, or A where B is a picture file, which has no story.
Side inspected_side(const Session& session);

}  // namespace ps::gui
