#include "gui/panels/lesson/lesson_claims.h"

#include <fmt/format.h>

#include <algorithm>

#include "gui/panels/lesson/lesson_panel.h"

namespace ps::gui {
namespace {

/// The parts of a document that change its pictures, and no others.
Document pictures_of(const Document& document) {
  Document pictures;
  pictures.scene_name = document.scene_name;
  pictures.base = document.base;
  pictures.scene = document.scene;
  pictures.edits = document.edits;
  pictures.view = document.view;
  pictures.view.zoom = 0;
  pictures.view.middle = PictureView{}.middle;
  pictures.a.settings = document.a.settings;
  pictures.b.settings = document.b.settings;
  return pictures;
}

}  // namespace

void LessonClaims::take_up(const Session& session, const Lesson& lesson) {
  const Document& document = session.document();
  measuring_.cancel();
  lesson_ = document.lesson;
  step_ = document.step;
  const LessonStep& step = lesson.steps.at(static_cast<std::size_t>(step_));
  claims_ = step.claims;
  step_state_ = step.state;
  shown_.assign(claims_.size(), ClaimShown::step);
  asked_.reset();
  before_.reset();
  measured_.reset();
  revision_ = 0;
}

Document LessonClaims::document_of(const Session& session, std::size_t claim, ClaimShown what) const {
  const Document& now = session.document();
  const Claim& of = claims_.at(claim);
  Document document = what == ClaimShown::mutation ? mutated_document(of, now) : claim_document(of, now);
  document.lesson = now.lesson;
  document.step = now.step;
  document.mode = now.mode;
  document.layout = now.layout;
  return document;
}

double LessonClaims::measured_value(const Job& job, Progress& progress) {
  Document document = job.screen;
  if (job.adds_own && !job.claim.own.scene.empty())
    document = claim_document(job.claim, job.screen);
  else if (job.adds_own)
    change_document(job.claim.own, document);
  return measure(job.metric, document, progress);
}

void LessonClaims::follow(const Session& session, const Lesson& lesson, int version) {
  const Document& document = session.document();
  if (static_cast<std::size_t>(document.step) >= lesson.steps.size()) return;
  if (lesson_ != document.lesson || step_ != document.step || version_ != version) take_up(session, lesson);
  version_ = version;
}

bool LessonClaims::measure_changed(const Session& session) {
  const Document& document = session.document();
  if (claims_.empty() || held_) return false;
  if (revision_ == session.revision() && measured_asked_ == asked_) return false;
  revision_ = session.revision();
  const Document pictures = pictures_of(document);
  Document now = pictures;
  if (std::any_of(claims_.begin(), claims_.end(),
                  [](const Claim& each) { return reads_pixel(each.metric) || reads_pixel(each.mutation.metric); }))
    now.pixel = document.pixel;
  if (measured_ && *measured_ == now && measured_asked_ == asked_) return false;
  measured_ = now;
  std::optional<Document> of_step;
  try {
    // Another scene would be loaded here, and is not on the screen anyway.
    if (step_state_.scene == document.scene_name) of_step = pictures_of(state_document(step_state_, document));
  } catch (const InputError&) {
    // The lesson itself says that its step cannot be shown.
  }
  for (std::size_t i = 0; i < claims_.size(); ++i) shown_[i] = shown_of(session, pictures, of_step, i);
  if (asked_ && shown_.at(asked_->claim) != asked_->what) asked_.reset();
  measured_asked_ = asked_;
  std::vector<Job> jobs;
  jobs.reserve(claims_.size());
  now.pixel = document.pixel;
  for (std::size_t i = 0; i < claims_.size(); ++i)
    jobs.push_back({claims_[i], metric(i), now, shown_[i] == ClaimShown::step});
  measuring_.start([jobs = std::move(jobs)](StudyControl& control, const auto& publish) {
    std::vector<Measured> found(jobs.size());
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      control.wait_here();
      try {
        found[i].value = measured_value(jobs[i], control.progress());
      } catch (const InputError& error) {
        found[i].trouble = error.what();
      }
      publish(std::make_shared<const std::vector<Measured>>(found), {});
    }
  });
  return true;
}

/// What undo, or the user's own hands, have put on the screen counts as well, unless it is the step itself.
ClaimShown LessonClaims::shown_of(const Session& session, const Document& pictures,
                                  const std::optional<Document>& of_step, std::size_t claim) const {
  const Claim& of = claims_.at(claim);
  const auto is_asked = [&](ClaimShown what) { return asked_ == Asked{claim, what}; };
  if (of.mutation.changes_metric && is_asked(ClaimShown::mutation)) return ClaimShown::mutation;
  const bool at_step = pictures == of_step;
  try {
    for (const ClaimShown what : {ClaimShown::mutation, ClaimShown::claim}) {
      if (what == ClaimShown::mutation ? of.mutation.changes_metric : !changes_anything(of.own)) continue;
      const LessonState& state = what == ClaimShown::mutation ? of.mutation.state : of.state;
      if (state.scene != pictures.scene_name) continue;  // it would be loaded here, and is not on the screen
      if ((is_asked(what) || !at_step) && pictures == pictures_of(document_of(session, claim, what))) return what;
    }
  } catch (const InputError&) {
    // Measuring it says why it cannot be shown.
  }
  return ClaimShown::step;
}

std::optional<double> LessonClaims::value(std::size_t claim) const {
  const auto found = measured_ ? measuring_.found() : nullptr;  // until then it is of the step before
  return found && claim < found->size() ? (*found)[claim].value : std::nullopt;
}

std::string LessonClaims::trouble(std::size_t claim) const {
  if (!measured_) return {};
  const auto found = measuring_.found();
  return found && claim < found->size() ? (*found)[claim].trouble : measuring_.message();
}

const Metric& LessonClaims::metric(std::size_t claim) const {
  const Claim& of = claims_.at(claim);
  return shown_.at(claim) == ClaimShown::mutation ? of.mutation.metric : of.metric;
}

void LessonClaims::show(Session& session, std::size_t claim, ClaimShown what) {
  const Claim& of = claims_.at(claim);
  asked_ = what == ClaimShown::step ? std::nullopt : std::optional(Asked{claim, what});
  if (of.mutation.changes_metric && what != ClaimShown::claim && shown_.at(claim) != ClaimShown::claim) return;
  const bool from_step =
      std::all_of(shown_.begin(), shown_.end(), [](ClaimShown shown) { return shown == ClaimShown::step; });
  if (what == ClaimShown::step) {
    if (!before_) return go_to_step(session, lesson_, step_);
    session.edit("back from a claim", [&](Document& document) {
      const Layout layout = document.layout;
      const ScreenMode mode = document.mode;
      document = *before_;
      document.layout = layout;
      document.mode = mode;
    });
    before_.reset();
    return;
  }
  if (from_step || !before_) before_ = session.document();
  session.edit(fmt::format("{}: {}", what == ClaimShown::claim ? "show" : "break", of.text),
               [&](Document& document) { document = document_of(session, claim, what); });
}

}  // namespace ps::gui
