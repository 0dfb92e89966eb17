#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gui/session/document_store.h"
#include "gui/session/loader.h"
#include "gui/session/picture_work.h"
#include "gui/session/selected_events.h"
#include "image/stored_picture.h"

namespace ps::gui {

/// A picture from a file that is in B's place.
struct PictureFile {
  std::string path;
  StoredPicture stored;
  Image<Rgb8> levels;
};

/// All of the program that is not a widget: the document with its history, what loads documents, and the work in the
/// background that the document asks for. For the window's thread; nothing here waits for work.
class Session final : public DocumentStore {
 public:
  explicit Session(const SessionHost& host) : loader_(host), work_(host.wake) {}

  /// Once per frame: takes up loaded scenes and changed files, and asks for the renders and stories that the document
  /// needs now.
  void update();
  /// At the end of a frame: asks for what the frame's changes need, so that work begins while the frame is drawn.
  void request_changed();
  /// Something is loading, rendering or being inspected, or has come and was not taken up.
  bool busy() const { return loader_.loading() || loader_.has_news() || work_.busy() || work_.has_news(); }

  Loader& loader() { return loader_; }
  const Loader& loader() const { return loader_; }
  PictureWork& work() { return work_; }
  const PictureWork& work() const { return work_; }
  RenderWorker& renderer(Side side) { return work_.renderer(side); }

  /// The story of the picked pixel; nullptr while there is none.
  std::shared_ptr<const PixelStory> story(Side side) const;
  /// The selected event of that story; -1 while none is, or while the story that it belongs to is still to come.
  int selected_event(Side side) const { return events_.selected(document(), side); }
  /// Renders and inspects everything anew: a renderer has changed.
  void draw_again();

  // --- scenes ---
  /// Shows a document that is complete. The first thing to call. Documents with the same `drag` (not empty) in a row
  /// are one step of the history.
  void start(Document document, const std::string& drag = {});
  /// Loads in the background; the scene that is open stays until it has come, and for good if it cannot be read.
  void open(const std::string& path_or_name);
  /// `file`: where it was read, if it was.
  void open_permalink(const std::string& text, const std::string& file = {});
  /// Reads the open scene again, or one that could not be opened, as long as its message is there.
  void reload();

  // --- a picture file in B's place ---
  /// Puts a picture file (png, ppm, pfm) there; the view takes its size. Errors become messages.
  void open_picture_b(const std::filesystem::path& path);
  /// B is rendered again.
  void close_picture_b();
  /// The file in B's place; nullptr while B is rendered.
  std::shared_ptr<const PictureFile> picture_b() const { return picture_b_; }
  /// The file in a side's place; nullptr while the side is rendered.
  std::shared_ptr<const PictureFile> file_of(Side side) const { return side == Side::b ? picture_b_ : nullptr; }

 private:
  void settle(const Document& before, Document& document) override { events_.settle(before, document); }
  void step_taken() override;
  void take_loaded(Loaded loaded);
  /// The file that could not be opened and whose message is still there; empty where there is none.
  std::string failed_scene() const;
  void reload_scene();
  /// Reads what was written anew: the open scene, or the one that failed.
  void follow_files();
  /// Watches the files of the open scene, and of one that failed.
  void watch_files();
  void take(Document document, LoadReason reason, const std::string& drag = {});
  /// Reads the picture file that the document has in B's place, and drops one that it has no longer. One that cannot be
  /// read, or is not of the picture's size, becomes a message, and B is rendered.
  void follow_picture_b();
  void give_up_picture_b(const std::string& why);
  void request_work();

  Loader loader_;
  PictureWork work_;
  SelectedEvents events_;
  std::shared_ptr<const PictureFile> picture_b_;
  std::string watched_;                     // name of the scene whose files are watched
  std::vector<std::string> failed_files_;   // the file that could not be opened, and where its error is
  std::optional<std::uint64_t> requested_;  // revision that work was last asked for
};

/// Whether a file is a picture, by its name: these are never scenes.
bool is_picture_file(const std::string& path);

/// The side whose story is shown: the picked one, or A where B is a picture file, which has no story.
Side inspected_side(const Session& session);

}  // namespace ps::gui
