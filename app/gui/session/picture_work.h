#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "document/document.h"
#include "gui/base/sides.h"
#include "gui/session/timed_pictures.h"
#include "gui/work/inspect_worker.h"
#include "gui/work/render_worker.h"

namespace ps::gui {

/// The renders and stories of both sides, made in the background.
class PictureWork {
 public:
  /// `wake` may be called from any thread.
  explicit PictureWork(std::function<void()> wake);

  /// Asks for the pictures and stories that the document needs, and drops others. `renders_b`: else a file is in B's
  /// place.
  void request(const Document& document, const SceneTraits& traits, bool renders_b);
  /// Renders and inspects everything anew, also what was prepared for it: a renderer has changed.
  void draw_again();
  /// All of the picture is to be new to the window.
  void begin_anew(Side side);

  RenderWorker& renderer(Side side) { return *renderers_[index_of(side)]; }
  const InspectWorker& inspector(Side side) const { return *inspectors_[index_of(side)]; }
  /// Takes up stories that have come.
  void take_news();
  /// A picture is being rendered.
  bool rendering() const;
  /// Something is being rendered or inspected.
  bool busy() const;
  /// Something has come that take_news() and RenderWorker::collect() have not taken up yet.
  bool has_news() const;

  /// How long pictures take, as far as that has been measured.
  TimedPictures& timed() { return timed_; }
  /// What has been built for the pictures, also for work that may end later than this.
  const std::shared_ptr<Prepared>& prepared() const { return prepared_; }

 private:
  std::optional<ValueRange> common_range(const Document& document);

  std::function<void()> wake_;
  std::shared_ptr<Prepared> prepared_ = std::make_shared<Prepared>();
  TimedPictures timed_;
  std::array<std::shared_ptr<const RenderResult>, 2> ranged_;  // results that range_ was made from
  std::optional<ValueRange> range_;

  // Last, so that their threads end before what they use.
  std::array<std::unique_ptr<RenderWorker>, 2> renderers_;
  std::array<std::unique_ptr<InspectWorker>, 2> inspectors_;
};

}  // namespace ps::gui
