#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/lesson.h"
#include "gui/session/session.h"
#include "gui/work/background_study.h"

namespace ps::gui {

/// What is on the screen, as far as a claim is concerned.
enum class ClaimShown {
  step,     ///< the step's own pictures, or what was made of them
  claim,    ///< those of the claim, which has settings of its own
  mutation  ///< those in which the claim must not hold
};

/// The claims of the open step: each measured in the background on what the screen shows, with the claim's own settings
/// added, so that a change of an option shows in the number. Its mutation can be put on the screen and taken back.
class LessonClaims {
 public:
  /// `wake` may be called from any thread.
  explicit LessonClaims(const std::function<void()>& wake) : measuring_(wake) {}

  /// Takes up the claims of the open step, once for each step and each `version` of the lesson.
  void follow(const Session& session, const Lesson& lesson, int version);
  /// Once in each frame in which a claim is in sight: measures anew if the pictures have changed. Answers whether it
  /// does, and what is known of the claims has changed with it.
  bool measure_changed(const Session& session);

  /// Pauses measuring while the pictures render, or a study measures times.
  void hold(bool held) {
    held_ = held;
    measuring_.set_held(held);
  }

  const std::vector<Claim>& claims() const { return claims_; }
  /// What was measured; absent while it is not known.
  std::optional<double> value(std::size_t claim) const;
  /// Why it cannot be measured; else empty.
  std::string trouble(std::size_t claim) const;
  ClaimShown shown(std::size_t claim) const { return claims_.empty() ? ClaimShown::step : shown_.at(claim); }
  /// The metric that is measured: the claim's, or that of its mutation.
  const Metric& metric(std::size_t claim) const;

  /// Puts the pictures of a claim or of its mutation on the screen; ClaimShown::step: those that were there before.
  void show(Session& session, std::size_t claim, ClaimShown what);

 private:
  struct Measured {
    std::optional<double> value;
    std::string trouble;
  };
  struct Job {
    Claim claim;
    Metric metric;
    Document screen;        ///< the pictures that are there
    bool adds_own = false;  ///< the claim's own settings are not on the screen
  };
  void take_up(const Session& session, const Lesson& lesson);
  Document document_of(const Session& session, std::size_t claim, ClaimShown what) const;
  /// Of the measuring thread, since it may load a scene. Throws InputError and Cancelled.
  static double measured_value(const Job& job, Progress& progress);

  std::string lesson_;
  int step_ = -1, version_ = -1;
  LessonState step_state_;
  std::vector<Claim> claims_;
  std::vector<ClaimShown> shown_;
  struct Asked {
    std::size_t claim = 0;
    ClaimShown what = ClaimShown::step;
    bool operator==(const Asked&) const = default;
  };
  ClaimShown shown_of(const Session& session, const Document& pictures, const std::optional<Document>& of_step,
                      std::size_t claim) const;

  std::optional<Asked> asked_;        // what was last put on the screen from here, while it is there
  std::optional<Document> before_;    // the screen before a claim or a mutation was shown
  std::optional<Document> measured_;  // pictures that were measured last
  std::optional<Asked> measured_asked_;
  std::uint64_t revision_ = 0;
  bool held_ = false;
  BackgroundStudy<std::vector<Measured>> measuring_;
};

}  // namespace ps::gui
