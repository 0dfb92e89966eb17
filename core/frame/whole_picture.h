#pragma once
#include "frame/frame.h"
#include "frame/prepared.h"
#include "frame/view.h"
#include "options/settings.h"

namespace ps {

/// A finished picture that is kept, so that each state of slow motion need not render it anew.
struct WholePicture {
  Frame frame;
  std::size_t heap_bytes() const;
};

/// The key of what is made of all settings, the whole scene and the view. `product` names it.
Key picture_key(std::string_view product, const Scene& scene, const View& view, const Settings& settings,
                const RenderRequest& request);

/// The picture that `render(settings, request)` gives, which is asked only where it is not kept yet. Of `request`,
/// only channels and region count.
template <class Render>
std::shared_ptr<const WholePicture> whole_picture(const Scene& scene, const View& view, const Settings& settings,
                                                  const RenderRequest& request, Prepared& prepared, Render&& render) {
  RenderRequest plain;
  plain.channels = request.channels;
  plain.priority = request.priority;
  plain.region = request.region;
  return prepared.get<WholePicture>(picture_key("whole picture", scene, view, settings, plain),
                                    [&] { return WholePicture{render(settings, plain)}; });
}

}  // namespace ps
