#include <fmt/format.h>

#include <map>
#include <memory>

#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/lesson_files.h"
#include "cli/output_file.h"
#include "engine/answers.h"
#include "engine/bug_question.h"
#include "engine/check_figures.h"
#include "engine/course.h"
#include "engine/lesson.h"
#include "engine/lesson_length.h"
#include "engine/lesson_place.h"
#include "engine/measured_pictures.h"
#include "engine/metric_words.h"
#include "record/value_text.h"

namespace ps::cli {
namespace {

int list_lessons() {
  for (const CoursePart& part : load_course().parts) {
    fmt::print("{}\n", part.title);
    for (const CourseLesson& each : part.lessons) {
      if (!is_built_in(each.name)) continue;
      const Lesson lesson = load_lesson(each.name);
      const LessonLength length = length_of(lesson);
      fmt::print("  {:<34} {} ({}; {} steps, {} claims, {} questions, {} min)\n", each.name, lesson.title,
                 lesson.source, length.steps, length.claims, length.questions, length.minutes());
      if (!each.after.empty()) fmt::print("  {:<34} after {}\n", "", fmt::join(each.after, ", "));
    }
  }
  for (const LeftOutLesson& each : lessons_left_out())
    fmt::print("Left out: {} needs the renderer '{}', which this program was built without.\n", each.name,
               each.renderer);
  return 0;
}

void print_state(const LessonState& state) {
  fmt::print("    scene {}\n", state.scene);
  for (const std::string& setting : state.set_a) fmt::print("    A: {}\n", setting);
  for (const std::string& setting : state.set_b) fmt::print("    B: {}\n", setting);
  for (const StatePart& part : state.parts) fmt::print("    {} {}\n", part.key, part.value);
}

void print_blocks(const std::vector<TextBlock>& blocks) {
  for (const TextBlock& block : blocks) {
    switch (block.kind) {
    case BlockKind::paragraph:
    case BlockKind::heading:
      fmt::print("\n{}\n", plain_text(block));
      break;
    case BlockKind::bullet:
      fmt::print("\n- {}\n", plain_text(block));
      break;
    case BlockKind::numbered:
      fmt::print("\n{}. {}\n", block.number, plain_text(block));
      break;
    case BlockKind::figure:
      fmt::print("\n[Figure: {}]\n", plain_text(block));
      break;
    }
  }
}

void print_notes(const std::vector<TextBlock>& notes) {
  for (const TextBlock& note : notes) fmt::print("\nFor the teacher: {}\n", plain_text(note));
}

int show_lesson(const std::string& name) {
  const Lesson lesson = load_lesson(name);
  fmt::print("{}\n{}\n", lesson.title, lesson.source);
  print_blocks(lesson.blocks);
  for (const TextBlock& goal : lesson.goals) fmt::print("\nAfterwards you can: {}\n", plain_text(goal));
  print_notes(lesson.notes);
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const LessonStep& step = lesson.steps[i];
    fmt::print("\n{}. {}\n", i + 1, step.title);
    print_state(step.state);
    print_blocks(step.blocks);
    for (const TextBlock& hint : step.hints) fmt::print("\nLook for: {}\n", plain_text(hint));
    for (const Claim& claim : step.claims)
      fmt::print("\nClaim: {} ({} {}; does not hold with {})\n", claim.text, metric_text(claim.metric),
                 bound_text(claim.bound), claim.mutation.text);
    if (step.question) fmt::print("\nQuestion ({}): {}\n", ask_text(*step.question), step.question->text);
    print_notes(step.notes);
  }
  return 0;
}

/// Numbers of what was checked so far.
struct Tally {
  std::size_t claims = 0, questions = 0, bugs = 0, failures = 0;
};

/// Everything, or only what shows that a lesson still holds: steps, links and claims as they are.
enum class CheckExtent { all, quick };

/// Whether a claim holds, not whether its mutation breaks it, and prints its row.
void check_as_it_stands(const Claim& claim, MeasuredPictures& pictures, Tally& tally) {
  ++tally.claims;
  const double value =
      measure(claim.metric, claim_document(claim, pictures.last()), interruptible_progress(), &pictures);
  const bool holds = claim.bound.holds(value);
  fmt::print("  {:<30} {:>9} {:<12} {:<13} {}\n", metric_text(claim.metric), measured_text(value),
             bound_text(claim.bound), holds ? "ok" : "DOES NOT HOLD", claim.text);
  if (!holds) ++tally.failures;
}

/// Checks one claim and prints its row.
void check(const Claim& claim, MeasuredPictures& pictures, Tally& tally) {
  ++tally.claims;
  const ClaimResult result = check_claim(claim, interruptible_progress(), &pictures);
  std::string verdict = "ok";
  if (!result.holds)
    verdict = "DOES NOT HOLD";
  else if (!result.has_teeth)
    verdict = "HOLDS WITH THE MUTATION TOO";
  fmt::print("  {:<30} {:>9} {:<12} {:>9} with {:<28} {:<13} {}\n", metric_text(claim.metric),
             measured_text(result.value), bound_text(claim.bound), measured_text(result.mutated_value),
             claim.mutation.text, verdict, claim.text);
  if (!result.passed()) ++tally.failures;
}

void check(const LessonQuestion& question, MeasuredPictures& pictures, Tally& tally) {
  ++(question.kind == AskKind::bug ? tally.bugs : tally.questions);
  std::string found;
  const std::string objection = check_question(question, interruptible_progress(), found, &pictures);
  fmt::print("  question {:<21} {} {} {}\n", ask_text(question), found, objection.empty() ? "ok" : "NO: " + objection,
             question.text);
  if (!objection.empty()) ++tally.failures;
}

/// Whether the step can be put on the screen; if not, says why.
bool check_state(const Lesson& lesson, std::size_t step) {
  try {
    lesson_document(lesson, static_cast<int>(step), Document{});
    return true;
  } catch (const InputError& error) {
    fmt::print("  step {} cannot be shown: {}\n", step + 1, error.what());
    return false;
  }
}

/// How many steps each lesson has that was read so far.
using StepCounts = std::map<std::string, std::size_t>;

std::size_t steps_of(const std::string& lesson, StepCounts& counts) {
  const auto known = counts.find(lesson);
  if (known != counts.end()) return known->second;
  return counts[lesson] = load_lesson(lesson).steps.size();
}

/// Checks in one text whether its links to steps of other lessons lead to steps that are there.
void check_links(const std::vector<TextBlock>& blocks, StepCounts& counts, Tally& tally) {
  for (const TextBlock& block : blocks)
    for (const TextSpan& span : block.spans) {
      if (span.link.kind != LinkKind::lesson) continue;
      const std::size_t steps = steps_of(span.link.target, counts);
      if (static_cast<std::size_t>(span.link.step) < steps) continue;
      fmt::print("  the link '{}' leads to step {} of {}, which has {}\n", span.text, span.link.step + 1,
                 span.link.target, steps);
      ++tally.failures;
    }
}

/// Whether figures have the numbers of the step's own pixel.
void check_figures(const Lesson& lesson, std::size_t step, Tally& tally) {
  for (const std::string& fault : figure_faults(lesson, static_cast<int>(step), interruptible_progress())) {
    fmt::print("  {}\n", fault);
    ++tally.failures;
  }
}

/// The claims and questions of a step.
void check_measured(const LessonStep& step, CheckExtent extent, MeasuredPictures& pictures, Tally& tally) {
  switch (extent) {
  case CheckExtent::quick:
    for (const Claim& claim : step.claims) check_as_it_stands(claim, pictures, tally);
    break;
  case CheckExtent::all:
    for (const Claim& claim : step.claims) check(claim, pictures, tally);
    if (step.question) check(*step.question, pictures, tally);
    break;
  }
}

int check_lessons(std::vector<std::string> names, CheckExtent extent) {
  if (names.empty()) names = lesson_names();
  Tally tally;
  StepCounts counts;
  MeasuredPictures pictures;
  for (const std::string& name : names) {
    const Lesson lesson = load_lesson(name);
    counts[lesson.name] = lesson.steps.size();
    fmt::print("{}\n", name);
    check_links(lesson.blocks, counts, tally);
    check_links(lesson.notes, counts, tally);
    if (const auto reason = why_not_here(lesson)) {
      fmt::print("  its claims are not checked: {}\n", *reason);
      continue;
    }
    for (const std::string& bug : bugs_without_step(lesson)) {
      fmt::print("  no step asks about bugs/{}.cpp\n", bug);
      ++tally.failures;
    }
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
      const LessonStep& step = lesson.steps[i];
      check_links(step.blocks, counts, tally);
      check_links(step.hints, counts, tally);
      check_links(step.notes, counts, tally);
      if (!check_state(lesson, i)) {
        ++tally.failures;
        continue;
      }
      check_figures(lesson, i, tally);
      check_measured(step, extent, pictures, tally);
    }
  }
  fmt::print("{} claims, {} questions, {} bugs checked, {} failed\n", tally.claims, tally.questions, tally.bugs,
             tally.failures);
  return tally.failures == 0 ? 0 : 1;
}

int export_answers(const std::string& student, const std::string& out) {
  const KeptAnswers kept = kept_answers(answers_file());
  write_result(answers_csv(kept.answers, student), out);
  for (const std::string& line : kept.damaged) fmt::print(stderr, "{}; skipped\n", line);
  return kept.damaged.empty() ? 0 : 1;
}

}  // namespace

void add_lessons_command(CLI::App& app, Action& chosen) {
  CLI::App* command =
      app.add_subcommand("lessons", "list, show, check or print the lessons; export answers; begin one");
  command->require_subcommand(0, 1);
  command->add_subcommand("list", "all lessons")->callback([&chosen] { chosen = list_lessons; });
  command->callback([&chosen] {
    if (!chosen) chosen = list_lessons;
  });

  CLI::App* show = command->add_subcommand("show", "the text of one lesson");
  const auto name = std::make_shared<std::string>();
  show->add_option("NAME", *name, "a lesson, or the folder of one")->required();
  show->callback([&chosen, name] { chosen = [name] { return show_lesson(*name); }; });

  CLI::App* check_command = command->add_subcommand(
      "check", "check claims, questions, bugs and links of the named lessons, or of all; exit status 1 if one fails");
  const auto names = std::make_shared<std::vector<std::string>>();
  check_command->add_option("NAME", *names, "lessons, or folders of lessons");
  const auto quick = std::make_shared<bool>(false);
  check_command->add_flag("--quick", *quick,
                          "only whether each step can be shown, its links lead somewhere and its claims hold: without "
                          "the claims' mutations, questions and the lines of bugs");
  add_lesson_file_commands(*command, chosen);
  CLI::App* answers = command->add_subcommand("answers", "the answers given in the window so far, as a table (CSV)");
  const auto student = std::make_shared<std::string>(), out = std::make_shared<std::string>();
  answers->add_option("--name", *student, "whose answers they are: the first column");
  answers->add_option("--out", *out, "file to write; without it the table is printed");
  answers->callback([&chosen, student, out] { chosen = [student, out] { return export_answers(*student, *out); }; });

  check_command->callback([&chosen, names, quick] {
    chosen = [names, quick] { return check_lessons(*names, *quick ? CheckExtent::quick : CheckExtent::all); };
  });
}

}  // namespace ps::cli
