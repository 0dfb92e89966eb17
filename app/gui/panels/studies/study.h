#pragma once
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gui/base/seen.h"
#include "gui/panels/panel.h"
#include "gui/widgets/widgets.h"
#include "gui/work/background_study.h"
#include "study/estimate.h"

namespace ps::gui {

/// The words of a study in its controls and messages.
struct StudyWords {
  std::string_view name;            ///< of its values for scripts: "chart/running"
  std::string_view title;           ///< in the line at the window's lower edge: "Chart"
  std::string_view measure, again;  ///< on the button that begins it, before there is a result and afterwards
  std::string_view help;            ///< tooltip of that button
  std::string_view preparing;       ///< what it does before the first of its units: "rendering the reference"
  std::string_view unit{};          ///< what it counts: "runs"; empty: one piece of work, which cannot be paused
  std::string_view kept{};          ///< what remains when it is stopped, a clause for a sentence's end; may be empty
};

/// The facts of a study's tool. A study needs height, and looks at all of the pictures.
PanelFacts study_facts(PanelFacts of);

/// A long measurement: its buttons, its line of status, its estimate, and the background work. A new study derives from
/// Study (below) and says how it is measured and drawn; all else is the same for all.
class StudyFrame : public Panel {
 public:
  /// Buttons, status and result.
  bool draw(const Context& context) override;
  /// The same in a panel that shows several studies.
  bool draw_part(bool filled);
  /// Takes up what has been found, lets the pictures' own renders pass, and stops an estimate that is not seen, which
  /// would take the processors from what is.
  void update() override;
  /// It measures now: neither paused nor over.
  bool measuring() const { return work_.state() == StudyState::running; }
  bool busy() const override;
  std::string status() const override;
  /// NAME/running, NAME/paused, NAME/estimating and what the study itself has for scripts.
  void offer(Values& out) override;

  /// Begins, or goes on with, the measurement of what is shown now.
  virtual void measure(Session& session) = 0;

 protected:
  StudyFrame(const PanelHost& host, const PanelFacts& of, const StudyWords& words, BackgroundWork& work,
             BackgroundWork* estimate = nullptr)
      : Panel(host, of), words_(words), work_(work), estimate_(estimate) {}

  /// Whether there is anything to measure; without, nothing is drawn.
  virtual bool has_subject(const Session& session) const { return session.has_scene(); }
  /// Before each drawing: what the document asks for.
  virtual void follow(Session&) {}
  /// Controls before and behind the button that begins the measurement.
  virtual void choices(Session&) {}
  virtual void more_controls(Session&) {}
  virtual void draw_result(Session& session) = 0;
  /// What the result is about, for the line of status while none runs.
  virtual std::string about(const Session& session) const = 0;
  /// Whether a stopped study is described, rather than what the result is about.
  virtual bool says_stopped() const { return true; }
  virtual std::string measure_word() const = 0;
  /// Why it cannot be measured now; empty if it can.
  virtual std::string reason_against(Session&) const { return {}; }
  /// Begins to estimate what the measurement will take, unless that is known. Called while it is drawn.
  virtual void keep_estimate(Session&) {}
  /// "about 40 s, 20 pictures"; empty: it is not estimated.
  virtual std::string expected() const { return {}; }
  virtual void take_up(Session& session) = 0;
  virtual void offer_found(Values&) const {}

  /// Whether the estimate for `key` has to be begun.
  bool estimate_lacks(const std::string& key);
  /// In place of an estimate that is not there.
  const char* unknown_time() const;
  void drop_estimate();

  const StudyWords words_;

 private:
  void run_buttons(Session& session, const std::string& word, const std::string& label);
  bool toolbar(Session& session, bool filled);
  std::string state_line(const Session& session) const;
  void status_line(const Session& session) const;

  BackgroundWork& work_;
  BackgroundWork* estimate_;
  std::string estimated_;  ///< what `estimate_` was begun for
  Seen seen_;
};

/// The typed half of a study, which holds the work and the newest result.
template <class Found>
class Study : public StudyFrame {
 public:
  std::shared_ptr<const Found> found;  ///< the newest; nullptr until there is anything

 protected:
  Study(const PanelHost& host, const PanelFacts& of, const StudyWords& words, BackgroundWork* estimate = nullptr)
      : StudyFrame(host, of, words, work, estimate), work(host.wake) {}

  /// Says how far the measurement is, and hands over what there is so far, if anything is.
  using Report = std::function<void(const StudyStatus&, std::shared_ptr<const Found>)>;
  /// Forgets the result, and measures in the background. `measurement` returns what it has found in the end,
  /// or nullptr: what it reported last. It may throw Cancelled and InputError.
  void start(std::function<std::shared_ptr<const Found>(StudyControl&, const Report&)> measurement) {
    found.reset();
    drop_estimate();  // it would disturb the times
    work.start([measurement = std::move(measurement)](StudyControl& control,
                                                      const typename BackgroundStudy<Found>::Publish& publish) {
      StudyStatus last;
      std::shared_ptr<const Found> newest;
      auto result = measurement(control, [&](const StudyStatus& status, std::shared_ptr<const Found> now) {
        last = status;
        if (now) newest = std::move(now);
        publish(newest, status);
      });
      if (result) newest = std::move(result);
      publish(newest, last);
    });
  }
  void take_up(Session& session) override {
    auto now = work.found();
    if (!now || now == taken_) return;
    found = taken_ = std::move(now);
    took(session);
  }
  std::string measure_word() const override { return std::string(found ? words_.again : words_.measure); }
  /// Called for each new result.
  virtual void took(Session&) {}

  BackgroundStudy<Found> work;

 private:
  std::shared_ptr<const Found> taken_;  ///< what was taken up last
};

/// A study whose time is estimated before it is begun.
template <class Found, class Estimate = StudyEstimate>
class EstimatedStudy : public Study<Found> {
 protected:
  EstimatedStudy(const PanelHost& host, const PanelFacts& of, const StudyWords& words)
      : Study<Found>(host, of, words, &estimate), estimate(host.wake) {}

  /// Answers the estimate for one request; renders small pictures for it.
  template <class Request>
  void begin_estimate(Estimate (*make)(const Request&, StudyControl&, const Clock&), Request request) {
    estimate.start([make, request = std::move(request)](StudyControl& control,
                                                        const typename BackgroundStudy<Estimate>::Publish& publish) {
      publish(std::make_shared<const Estimate>(make(request, control, steady_seconds)), {1, 1, 0});
    });
  }

  BackgroundStudy<Estimate> estimate;
};

/// Several studies in one panel, of which one is shown.
class StudyParts : public Panel {
 public:
  bool draw(const Context& context) override;
  void offer(Values& out) override;
  void update() override;
  bool busy() const override;
  bool measures_times() const override;
  std::string status() const override;

 protected:
  struct Part {
    Choice choice;
    StudyFrame& study;
    std::function<bool()> applies = {};  ///< to the pictures that are shown; empty: always
  };
  StudyParts(const PanelHost& host, const PanelFacts& of) : Panel(host, study_facts(of)) {}
  /// To be called once, when the studies are made; the first is shown.
  void add(std::vector<Part> parts) { parts_ = std::move(parts); }

 private:
  std::vector<Part> parts_;
  std::string_view shown_;  ///< the key of what was chosen; where it does not apply, the first that does is shown
};

/// The scene with its edits, as new as its file, and the camera, as text.
std::string scene_key(const Session& session);
/// All that a picture of the open scene with a side's settings follows from, as text.
std::string picture_key(const Session& session, Side side);
/// The allowed FLIP of the worst tile, with what that means in words.
void tolerance_control(double& tolerance);

/// "12 of 40 runs, 8 s left"; "12 runs" where their total is unknown; empty before the first.
std::string status_text(const StudyStatus& status, std::string_view unit);

/// Why B cannot be measured, where a picture file is in its place; else empty.
std::string why_not_b(const Session& session);

/// Two buttons, A and B; only A where B is a file.
void side_choice(const Session& session, Side& side, std::string_view help_a, std::string_view help_b);

}  // namespace ps::gui
