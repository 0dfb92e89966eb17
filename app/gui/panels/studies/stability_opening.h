#pragma once
#include <filesystem>
#include <memory>

#include "gui/session/session.h"
#include "gui/work/background_study.h"
#include "study/stability/pictures.h"

namespace ps::gui {

/// One point of an experiment, being made ready for A and B in the background.
using StabilityOpeningStudy = BackgroundStudy<StabilityOpening>;
void begin_opening(StabilityOpeningStudy& study, const StabilityExperiment& experiment, double knob);

/// Shows the point: the naive method in A, the robust one in B, a failing pixel picked. A scene of the experiment's own
/// is written into `folder`, so that it can be opened again. Throws InputError.
void show_opening(Session& session, const StabilityOpening& opening, const std::filesystem::path& folder);

}  // namespace ps::gui
