#pragma once
#include "render/render.h"

/// Pictures and stories for tests that prepare each scene afresh.

namespace ps {

inline Frame render(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request) {
  Prepared prepared;
  Progress progress;
  return render(scene, view, settings, request, prepared, progress);
}

inline PixelStory inspect(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel) {
  Prepared prepared;
  Progress progress;
  return inspect(scene, view, settings, pixel, prepared, progress);
}

/// The request for a picture with these channels, or of this region alone.
inline RenderRequest request_for(Channel channels, const std::optional<TileRect>& region = {}) {
  RenderRequest request;
  request.channels = channels;
  request.region = region;
  return request;
}

}  // namespace ps
