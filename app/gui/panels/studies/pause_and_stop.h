#pragma once
#include <algorithm>
#include <string_view>

#include "gui/widgets/widgets.h"
#include "gui/work/background_study.h"

namespace ps::gui {

/// Width of both buttons, window pixels.
inline float pause_and_stop_width() {
  return std::max(button_width("Go on"), button_width("Pause")) + px(3) + button_width("Stop");
}

/// The buttons `pause` and `cancel` of a study that runs. `kept` says what remains when it is stopped.
template <class Found>
void pause_and_stop(BackgroundStudy<Found>& study, std::string_view kept) {
  const bool paused = study.state() == StudyState::paused;
  if (button("pause", paused ? "Go on" : "Pause", Emphasis::plain,
             {.width = std::max(button_width("Go on"), button_width("Pause"))}))
    study.set_paused(!paused);
  ImGui::SameLine(0, px(3));
  if (button("cancel", "Stop", Emphasis::plain, {.tooltip = kept, .width = 0})) study.cancel();
}

}  // namespace ps::gui
