#pragma once
#include <cstdint>
#include <optional>

#include "gui/panels/pictures/picture_view.h"
#include "render/channel_picture.h"

namespace ps::gui {

/// One side's picture as it was before the document's last change. A drag is one change, however many pictures it
/// makes.
class PictureBefore {
 public:
  /// Takes over a finished picture. `change` is Session::change() of the document that it shows.
  void take(const Image<Rgb8>& levels, ShownChannel channel, std::uint64_t change);
  /// The picture before `change`, ready to be drawn. nullptr if that change made no new picture of this side, or one of
  /// another size or channel.
  const ShownPicture* before(std::uint64_t change);

 private:
  struct Settled {
    Image<Rgb8> levels;
    ShownChannel channel = ShownChannel::colour;
    std::uint64_t change = 0;
  };
  std::optional<Settled> now_, before_;
  ShownPicture drawn_;  // before_, once it has been asked for
  bool is_uploaded_ = false;
};

}  // namespace ps::gui
