#include "study/study_frame.h"

namespace ps {

Frame study_frame(const Scene& scene, const View& view, const Settings& settings, StudyControl& control,
                  WorkerPriority priority, Prepared& prepared, Channel channels) {
  control.wait_here();
  RenderRequest how;
  how.channels = channels;
  how.priority = priority;
  return render(scene, view, settings, how, prepared, control.progress());
}

}  // namespace ps
