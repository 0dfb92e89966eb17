#pragma once
#include <optional>
#include <string>

#include "gui/session/session.h"

namespace ps::gui {

/// Work that a lesson's step began without being asked for. Who leaves the step needs the processors for something
/// else; who comes back wants it to go on.
class StepWork {
 public:
  /// It begins for the step that is open; none is noted without a lesson.
  void begin(const Session& session) {
    const Document& document = session.document();
    if (!document.lesson.empty()) of_ = Step{document.lesson, document.step};
  }
  /// From now on the work has been asked for.
  void forget() { of_.reset(); }
  /// Answers, once, that its step was left.
  bool leave(const Session& session) {
    if (!of_ || of_->left || here(session)) return false;
    of_->left = true;
    return true;
  }
  /// The result is no longer wanted.
  bool left() const { return of_ && of_->left; }
  /// To the step that was left.
  bool came_back(const Session& session) const { return left() && here(session); }

 private:
  struct Step {
    std::string lesson;
    int step = 0;
    bool left = false;
  };
  bool here(const Session& session) const {
    return session.document().lesson == of_->lesson && session.document().step == of_->step;
  }

  std::optional<Step> of_;
};

}  // namespace ps::gui
