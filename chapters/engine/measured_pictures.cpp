#include "engine/measured_pictures.h"

#include <algorithm>

#include "render/render.h"

namespace ps {

std::shared_ptr<const Frame> MeasuredPictures::frame(const Document& document, const Settings& settings,
                                                     Channel channels, Progress& progress) {
  constexpr std::size_t most = 8;  // a picture of 600 x 600 pixels has 4 MB and more
  Key key{document.base.revision(), document.edits, view_of(document), document.view.region, settings, channels};
  const auto known = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& kept) { return kept.key == key; });
  if (known != kept_.end()) {
    kept_.splice(kept_.begin(), kept_, known);
  } else {
    RenderRequest request;
    request.channels = channels;
    request.region = document.view.region;
    auto frame = std::make_shared<const Frame>(
        render(document.scene, view_of(document), settings, request, prepared_, progress));
    ++rendered_;
    kept_.push_front({std::move(key), std::move(frame)});
    if (kept_.size() > most) kept_.pop_back();
  }
  last_ = document;
  return kept_.front().frame;
}

}  // namespace ps
