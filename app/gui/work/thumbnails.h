#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <vector>

#include "document/document.h"
#include "frame/prepared.h"
#include "gui/platform/texture.h"
#include "gui/work/newest_job.h"

namespace ps::gui {

/// A and B of a document side by side, each at most `width` by `height` pixels, with a line between them. What cannot
/// be rendered stays empty.
Image<Rgb8> thumbnail(const Document& document, int width, int height, Prepared& prepared, Progress& progress);
/// A alone. Throws InputError if its settings do not fit the scene.
Image<Rgb8> thumbnail_of_a(const Document& document, int width, int height, Prepared& prepared, Progress& progress);

/// Small pictures, made in the background one by one, kept by id. For the window's thread; nothing waits.
class Thumbnails {
 public:
  /// Makes one, on another thread. May throw InputError: the picture is empty then.
  using Make = std::function<Image<Rgb8>(Prepared&, Progress&)>;

  /// `wake` is called from another thread when a picture has come.
  explicit Thumbnails(std::function<void()> wake);

  /// The picture of this id, or nullptr while it is being made. `width` and `height` are its largest size; other ones
  /// make all pictures anew.
  const Texture* find(std::uint64_t id, int width, int height, Make make);
  /// Once per frame after all find(): takes up what has come, starts the next, forgets those not among `ids`.
  void update(const std::set<std::uint64_t>& ids);
  bool busy() const;
  /// How many there are, empty ones among them.
  std::size_t count() const { return made_.size(); }

 private:
  struct Made {
    std::uint64_t id = 0;
    Image<Rgb8> picture;
  };
  const std::function<void()> wake_;
  const std::shared_ptr<Prepared> prepared_ = std::make_shared<Prepared>();
  int width_ = 0, height_ = 0;
  std::map<std::uint64_t, Texture> made_;
  std::vector<std::pair<std::uint64_t, Make>> wanted_;  // in this frame, not made yet
  mutable std::mutex mutex_;                            // guards all down to arrived_
  bool running_ = false;
  std::optional<Made> arrived_;

  NewestJob job_;  // last, so that its thread ends before what it uses
};

}  // namespace ps::gui
