#include "gui/work/space_worker.h"

#include <memory>
#include <utility>

namespace ps::gui {
namespace {

bool same_space(const SpaceRequest& a, const SpaceRequest& b) {
  return a.scene.revision() == b.scene.revision() && a.view == b.view && a.near == b.near;
}

}  // namespace

SpaceWorker::SpaceWorker(std::function<void()> wake)
    : LatestResult(
          [prepared = std::make_shared<Prepared>()](const SpaceRequest& request, Progress& progress) {
            return draw_space_picture(request.scene, request.view, request.near, *prepared, progress);
          },
          same_space, std::move(wake)) {}

}  // namespace ps::gui
