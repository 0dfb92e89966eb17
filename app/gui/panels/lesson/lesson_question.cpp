#include "gui/panels/lesson/lesson_question.h"

#include <fmt/format.h>

#include "engine/answers.h"
#include "options/listing.h"
#include "options/renderer_kind.h"

namespace ps::gui {
namespace {

std::string key_of(const std::string& lesson, int step) { return fmt::format("{}/{}", lesson, step); }

std::string_view verdict_words(double points) {
  return points >= 1 ? "That was right." : points > 0 ? "That was nearly right." : "That was not right.";
}

}  // namespace

LessonQuestions::LessonQuestions(const std::function<void()>& wake, bool remember, LessonShelf& shelf)
    : shelf_(shelf), remember_(remember), measuring_(wake) {}

/// At the first question, so that a start of the window without one reads no file.
void LessonQuestions::read_answers(Session& session) {
  if (answers_read_ || !remember_) return;
  answers_read_ = true;
  try {
    const KeptAnswers kept = kept_answers(answers_file());
    if (!kept.damaged.empty())
      session.say(Message::Kind::warning,
                  fmt::format("{} of {} lines of the answers of before are damaged and skipped. The first: {}",
                              kept.damaged.size(), kept.damaged.size() + kept.answers.size(), kept.damaged.front()));
    for (const GivenAnswer& each : kept.answers)
      answered_[key_of(each.lesson, each.step)] = {
          each.answer, {each.points, fmt::format("You answered: {}. {}", each.answer, verdict_words(each.points))}};
  } catch (const InputError& error) {
    remember_ = false;  // what is there is left as it is
    session.say(Message::Kind::warning,
                fmt::format("The answers of before cannot be read, and no new ones are kept: {}", error.what()));
  }
}

bool LessonQuestions::asked_beside_text(const Session& session) const {
  const Document& document = session.document();
  return open() && document.mode != ScreenMode::presenter && document.layout.panels;
}

const Judgement* LessonQuestions::verdict() const {
  const auto found = answered_.find(here_);
  return question_ && found != answered_.end() ? &found->second.judgement : nullptr;
}

std::string LessonQuestions::given() const {
  const auto found = answered_.find(here_);
  return question_ && found != answered_.end() ? found->second.words : "";
}

bool LessonQuestions::follow(Session& session) {
  const Document& document = session.document();
  const std::string here = document.lesson.empty() ? "" : key_of(document.lesson, document.step);
  const Lesson* lesson = shelf_.open();
  if (here == here_ && version_ == shelf_.version()) return false;
  here_ = here;
  version_ = shelf_.version();
  question_.reset();
  measuring_.cancel();
  to_measure_ = false;
  answer = {};
  typed.clear();
  pixel_before = document.pixel;
  if (!lesson || static_cast<std::size_t>(document.step) >= lesson->steps.size()) return true;
  question_ = lesson->steps[static_cast<std::size_t>(document.step)].question;
  if (question_) read_answers(session);
  to_measure_ = question_ && question_->kind != AskKind::pixel;
  return true;
}

void LessonQuestions::hold(bool held) {
  measuring_.set_held(held);
  if (held || !to_measure_) return;
  to_measure_ = false;
  measuring_.start([question = *question_](StudyControl& control, const auto& publish) {
    publish(std::make_shared<const MeasuredAnswer>(measure_answer(question, control.progress())), {});
  });
}

bool LessonQuestions::bug_shown(const Session& session) const {
  if (!question_ || question_->kind != AskKind::bug || !session.has_scene()) return false;
  const Settings& settings = session.settings(Side::a);
  if (!runs_listing(settings.renderer)) return false;
  const auto measured = right();
  return !measured || running_listing(settings, scene_traits(session.scene())).bug == measured->bug;
}

std::optional<BugLine> LessonQuestions::bug_verdict(const Session& session) const {
  const auto measured = right();
  if (!measured || !verdict() || !bug_shown(session)) return {};
  return measured->line;
}

void LessonQuestions::take(Session& session, const std::string& given, const Judgement& judgement) {
  answered_[here_] = {given, judgement};
  turn_to_verdict = true;
  const Document& document = session.document();
  if (!remember_ || !question_ || given.empty()) return;
  try {
    keep_answer(answers_file(),
                {answer_time(), document.lesson, document.step, question_->text, given, judgement.points});
  } catch (const InputError& error) {
    session.say(Message::Kind::warning, fmt::format("The answer is not kept: {}", error.what()));
    remember_ = false;
  }
}

void LessonQuestions::tell_skipped(const Session& session) {
  const auto found = answered_.find(here_);
  if (!question_ || found == answered_.end()) return;
  const auto& [words, judgement] = found->second;
  if (!words.empty() || !judgement.sentence.empty()) return;
  std::string& sentence = found->second.judgement.sentence;
  if (question_->kind != AskKind::pixel) {
    if (const auto measured = right()) sentence = right_sentence(*question_, *measured);
    return;
  }
  const auto story = session.story(inspected_side(session));
  if (story && story->pixel == pixel_before) sentence = right_sentence(*question_, *story, session.scene());
}

void LessonQuestions::ask_again() {
  answered_.erase(here_);
  version_ = -1;
}

std::string told_answer(const LessonQuestions& questions) {
  const Judgement* verdict = questions.verdict();
  if (verdict && !verdict->sentence.empty()) return verdict->sentence;
  return questions.measuring() ? "The answer is being measured." : questions.failure();
}

std::optional<StepVerdict> shown_verdict(const LessonQuestions& questions) {
  const Judgement* verdict = questions.verdict();
  if (!verdict) return {};
  StepVerdict shown{questions.question()->text, verdict->sentence, {}};
  if (!questions.given().empty())
    shown.points = verdict->points;
  else
    shown.sentence = "You have skipped it. " + told_answer(questions);
  return shown;
}

}  // namespace ps::gui
