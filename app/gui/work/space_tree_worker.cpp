#include "gui/work/space_tree_worker.h"

#include <utility>

#include "base/stop.h"

namespace ps::gui {

bool same_request(const SpaceTreeRequest& a, const SpaceTreeRequest& b) {
  return a.story == b.story && a.prepared == b.prepared && a.settings == b.settings &&
         a.scene.revision() == b.scene.revision();
}

SpaceTreeWorker::SpaceTreeWorker(std::function<void()> wake)
    : LatestResult(
          [](const SpaceTreeRequest& request, Progress& progress) {
            const StopScope stop(&progress);
            SpaceTreeNodes found{request, {}, {}};
            found.tree = add_tree(request.scene, request.settings, request.story.get(), *request.prepared, found.nodes);
            return found;
          },
          same_request, std::move(wake),
          [](const SpaceTreeRequest& started, const SpaceTreeRequest& wanted) {
            return !same_request(started, wanted);
          }) {}

}  // namespace ps::gui
