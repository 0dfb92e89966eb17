#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "gui/session/session.h"

namespace ps::gui {

/// The work for the pictures of one step of the history.
struct WorkOfStep {
  std::uint64_t step = 0;  ///< History::Entry::id
  struct Picture {
    double milliseconds = 0;            ///< of one run
    std::optional<std::uint64_t> work;  ///< counted_work(); nullopt where the renderer counts none
  };
  std::array<std::optional<Picture>, 2> pictures;  ///< of A and B; nullopt where B is a file
};

/// Time and counted work over the last changes, in the order in which they were rendered first. A step that is
/// rendered again has its newest run.
class WorkLog {
 public:
  static constexpr std::size_t most_steps = 40;

  /// Notes the pictures that are complete now; once per frame.
  void update(Session& session);
  /// Adds a step, or replaces what is known of it.
  void note(const WorkOfStep& work);
  const std::vector<WorkOfStep>& steps() const { return steps_; }

 private:
  std::vector<WorkOfStep> steps_;
  std::array<std::shared_ptr<const RenderResult>, 2> noted_;
  std::uint64_t noted_step_ = 0;
};

}  // namespace ps::gui
