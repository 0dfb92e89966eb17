#pragma once
#include <deque>

#include "base/statistics.h"
#include "gui/work/render_worker.h"

namespace ps::gui {

/// How long a picture takes: of warm runs, while nothing else was rendered.
struct TimedPicture {
  PictureRequest request;
  Quartiles ms;
  int runs = 0;
};

/// The pictures that have been timed lately, so that the time of one that comes back, for example by undo, is known.
class TimedPictures {
 public:
  void add(TimedPicture timed);
  /// The times of this picture; nullptr if it has not been timed.
  const TimedPicture* find(const PictureRequest& request) const;

 private:
  std::deque<TimedPicture> newest_first_;
};

}  // namespace ps::gui
