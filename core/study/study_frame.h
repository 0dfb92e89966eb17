#pragma once
#include "render/render.h"
#include "study/control.h"

namespace ps {

/// Renders one picture of a study, which waits before it while the study is paused. Throws Cancelled.
Frame study_frame(const Scene& scene, const View& view, const Settings& settings, StudyControl& control,
                  WorkerPriority priority, Prepared& prepared, Channel channels = Channel::none);

}  // namespace ps
