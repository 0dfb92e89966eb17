#pragma once
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "gui/session/session.h"
#include "inspect/parting/align_stories.h"
#include "inspect/parting/parting.h"

namespace ps::gui {

/// State of the view of the parting between frames: the comparison of the two stories it was last made for.
struct PartingViewState {
  std::array<std::shared_ptr<const PixelStory>, 2> shown_stories;
  Parting parting;
  std::vector<AlignedRow> rows;
  bool all_steps = false;  ///< those that are the same in both are listed too, and those that say little
  bool reveal = false;     ///< the step at which they part shall be brought into view
};

/// The first clause of a sentence as a headline, and what follows `divider` as text below it.
void headline(const std::string& name, const std::string& text, std::string_view divider);

/// The stories of A and B step by step beside each other, with the first difference marked and its cause in a sentence.
/// A click on a step selects it in both stories.
void parting_view(Session& session, PartingViewState& state,
                  const std::array<std::shared_ptr<const PixelStory>, 2>& stories);

}  // namespace ps::gui
