#pragma once
#include <memory>
#include <vector>

#include "gui/panels/pictures/picture_transform.h"
#include "gui/work/render_worker.h"

namespace ps::gui {

/// Pixels of a picture whose colour is not a number. They would be shown as black, which is a colour like any other:
/// instead they are hatched in magenta and black, and never smaller than can be seen.
class NanPixels {
 public:
  void draw(ImDrawList& list, const std::shared_ptr<const RenderResult>& result, const PictureTransform& transform,
            const Area& area);

 private:
  void find(const std::shared_ptr<const RenderResult>& result);

  std::shared_ptr<const RenderResult> found_in_;
  std::vector<TileRect> runs_;  // of one row each
};

}  // namespace ps::gui
