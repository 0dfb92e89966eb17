#include "gui/panels/pictures/picture_before.h"

#include <utility>

namespace ps::gui {

void PictureBefore::take(const Image<Rgb8>& levels, ShownChannel channel, std::uint64_t change) {
  if (now_ && now_->change != change) {
    before_ = std::exchange(now_, std::nullopt);
    is_uploaded_ = false;
  }
  now_ = Settled{levels, channel, change};
}

const ShownPicture* PictureBefore::before(std::uint64_t change) {
  if (!now_ || !before_ || now_->change != change || now_->channel != before_->channel) return nullptr;
  const Image<Rgb8>& levels = before_->levels;
  if (levels.width() != now_->levels.width() || levels.height() != now_->levels.height()) return nullptr;
  if (!std::exchange(is_uploaded_, true)) {
    drawn_.levels = levels;
    drawn_.upload({{0, 0, levels.width(), levels.height()}});
  }
  return &drawn_;
}

}  // namespace ps::gui
