#include "gui/work/thumbnails.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "frame/display_frame.h"
#include "render/render.h"

namespace ps::gui {
namespace {

constexpr int line_between = 2;  // pixels

/// The document's view, made so small that it fits.
View small_view(const Document& document, int width, int height) {
  View view = view_of(document);
  const double shrink =
      std::min({1.0, static_cast<double>(width) / view.width, static_cast<double>(height) / view.height});
  view.width = std::max(1, static_cast<int>(view.width * shrink));
  view.height = std::max(1, static_cast<int>(view.height * shrink));
  return view;
}

Image<Rgb8> side_picture(const Document& document, Side side, const View& view, Prepared& prepared,
                         Progress& progress) {
  const SideState& state = side_of(document, side);
  RenderRequest request;
  request.channels = shown_channel(state.show).needs;
  if (document.field) request.field = std::make_shared<const ShownField>(*document.field);
  request.priority = WorkerPriority::background;
  const Frame frame = render(document.scene, view, state.settings, request, prepared, progress);
  return state.show == ShownChannel::colour ? display_frame(frame, state.settings)
                                            : channel_picture(frame, state.show, state.settings).levels;
}

}  // namespace

Image<Rgb8> thumbnail(const Document& document, int width, int height, Prepared& prepared, Progress& progress) {
  const View view = small_view(document, width, height);
  constexpr Rgb8 paper{128, 128, 128};
  Image<Rgb8> picture(2 * view.width + line_between, view.height, paper);
  for (const Side side : {Side::a, Side::b}) {
    const int left = side == Side::a ? 0 : view.width + line_between;
    try {
      const auto one = side_picture(document, side, view, prepared, progress);
      for (int y = 0; y < view.height; ++y)
        std::copy(one.row(y).begin(), one.row(y).end(), picture.row(y).begin() + left);
    } catch (const InputError&) {
      // Settings that do not fit the scene: this half stays grey, as the picture itself did.
    }
  }
  return picture;
}

namespace {

/// Each pixel is the mean of the levels of those that it covers, or nearly covers.
Image<Rgb8> shrunk_to(const Image<Rgb8>& large, int width, int height) {
  Image<Rgb8> small(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int x0 = x * large.width() / width, x1 = std::max(x0 + 1, (x + 1) * large.width() / width);
      const int y0 = y * large.height() / height, y1 = std::max(y0 + 1, (y + 1) * large.height() / height);
      int sum[3] = {};
      for (int row = y0; row < y1; ++row)
        for (int column = x0; column < x1; ++column) {
          const Rgb8 level = large.at(column, row);
          sum[0] += level.r;
          sum[1] += level.g;
          sum[2] += level.b;
        }
      const int count = (x1 - x0) * (y1 - y0);
      const auto mean = [&](int channel) { return static_cast<std::uint8_t>((sum[channel] + count / 2) / count); };
      small.at(x, y) = {mean(0), mean(1), mean(2)};
    }
  return small;
}

}  // namespace

// What lies on the canvas is measured in its pixels: it is drawn in full size and shrunk. So is a picture of twice the
// size, whose edges are smoother for it.
Image<Rgb8> thumbnail_of_a(const Document& document, int width, int height, Prepared& prepared, Progress& progress) {
  const View small = small_view(document, width, height);
  View large = view_of(document);
  if (document.scene.canvas_items->empty()) {
    large.width = std::min(large.width, 2 * small.width);
    large.height = std::min(large.height, 2 * small.height);
  }
  return shrunk_to(side_picture(document, Side::a, large, prepared, progress), small.width, small.height);
}

Thumbnails::Thumbnails(std::function<void()> wake) : wake_(std::move(wake)) {}

const Texture* Thumbnails::find(std::uint64_t id, int width, int height, Make make) {
  if (width != width_ || height != height_) {
    made_.clear();
    width_ = width;
    height_ = height;
  }
  if (const auto found = made_.find(id); found != made_.end()) return &found->second;
  wanted_.emplace_back(id, std::move(make));
  return nullptr;
}

void Thumbnails::update(const std::set<std::uint64_t>& ids) {
  const auto wanted = std::exchange(wanted_, {});
  std::optional<Made> arrived;
  {
    const std::lock_guard lock(mutex_);
    arrived = std::exchange(arrived_, std::nullopt);
  }
  if (arrived) {
    Texture& made = made_[arrived->id];
    if (arrived->picture.width() > 0) made.upload(arrived->picture);
  }
  std::erase_if(made_, [&](const auto& entry) { return ids.count(entry.first) == 0; });
  {
    const std::lock_guard lock(mutex_);
    if (running_ || arrived_) return;
    const auto next = std::find_if(wanted.begin(), wanted.end(),
                                   [&](const auto& one) { return !arrived || one.first != arrived->id; });
    if (next == wanted.end()) return;
    running_ = true;
    job_.start([this, id = next->first, make = next->second](Progress& progress) {
      Made made{id, {}};
      try {
        made.picture = make(*prepared_, progress);
      } catch (const InputError&) {
        // Stays empty.
      }
      {
        const std::lock_guard made_lock(mutex_);
        running_ = false;
        arrived_ = std::move(made);
      }
      if (wake_) wake_();
    });
  }
}

bool Thumbnails::busy() const {
  const std::lock_guard lock(mutex_);
  return running_ || arrived_;
}

}  // namespace ps::gui
