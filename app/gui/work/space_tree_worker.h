#pragma once
#include <functional>
#include <memory>

#include "gui/work/latest_result.h"
#include "inspect/space_tree.h"

namespace ps::gui {

/// The nodes of an accelerator that no ray of the story came to.
struct SpaceTreeRequest {
  Scene scene;
  Settings settings;
  std::shared_ptr<const PixelStory> story;
  Prepared* prepared = nullptr;  ///< the session's, which outlives the worker: the picture has left its tree there
};

struct SpaceTreeNodes {
  SpaceTreeRequest of;  ///< what they were asked for with
  SpaceModel nodes;     ///< nothing but those nodes
  SpaceTree tree;
};

bool same_request(const SpaceTreeRequest& a, const SpaceTreeRequest& b);

/// Finds them in the background, since a tree that `prepared` has dropped meanwhile must be built anew.
class SpaceTreeWorker : public LatestResult<SpaceTreeRequest, SpaceTreeNodes> {
 public:
  explicit SpaceTreeWorker(std::function<void()> wake);
};

}  // namespace ps::gui
