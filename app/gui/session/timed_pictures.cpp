#include "gui/session/timed_pictures.h"

#include <algorithm>

namespace ps::gui {
namespace {

constexpr std::size_t most_kept = 24;
bool same_picture(const PictureRequest& a, const PictureRequest& b) { return a.shown == b.shown && same_render(a, b); }

}  // namespace

void TimedPictures::add(TimedPicture timed) {
  std::erase_if(newest_first_, [&](const TimedPicture& old) { return same_picture(old.request, timed.request); });
  newest_first_.push_front(std::move(timed));
  if (newest_first_.size() > most_kept) newest_first_.pop_back();
}

const TimedPicture* TimedPictures::find(const PictureRequest& request) const {
  const auto found = std::find_if(newest_first_.begin(), newest_first_.end(),
                                  [&](const TimedPicture& one) { return same_picture(one.request, request); });
  return found == newest_first_.end() ? nullptr : &*found;
}

}  // namespace ps::gui
