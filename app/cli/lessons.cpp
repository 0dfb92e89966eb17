#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "cli/command.h"
#include "cli/interrupt.h"
#include "engine/claim.h"
#include "engine/lesson.h"
#include "record/value_text.h"

namespace ps::cli {
namespace {

int list_lessons() {
  for (const std::string& name : lesson_names()) {
    const Lesson lesson = load_lesson(name);
    const auto claims = [&] {
      std::size_t count = 0;
      for (const LessonStep& step : lesson.steps) count += step.claims.size();
      return count;
    }();
    fmt::print("{:<34} {} ({}; {} steps, {} claims)\n", name, lesson.title, lesson.source, lesson.steps.size(), claims);
  }
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
    }
  }
}

int show_lesson(const std::string& name) {
  const Lesson lesson = load_lesson(name);
  fmt::print("{}\n{}\n", lesson.title, lesson.source);
  print_blocks(lesson.blocks);
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const LessonStep& step = lesson.steps[i];
    fmt::print("\n{}. {}\n", i + 1, step.title);
    print_state(step.state);
    print_blocks(step.blocks);
    for (const TextBlock& hint : step.hints) fmt::print("\nLook for: {}\n", plain_text(hint));
    for (const Claim& claim : step.claims)
      fmt::print("\nClaim: {} ({} {} {}; does not hold with the default {})\n", claim.text, metric_key(claim.metric),
                 bound_text(claim.bound), number_text(claim.number), claim.mutation);
  }
  return 0;
}

/// Checks one claim and prints its row. Gives whether it passed.
bool check(const Claim& claim) {
  const ClaimResult result = check_claim(claim, interruptible_progress());
  std::string verdict = "ok";
  if (!result.holds)
    verdict = "DOES NOT HOLD";
  else if (!result.has_teeth)
    verdict = fmt::format("HOLDS WITHOUT {} TOO", claim.mutation);
  fmt::print("  {:<20} {:>9} {:>2} {:<8} {:>9} with the default {:<18} {:<13} {}\n", metric_key(claim.metric),
             number_text(result.value), bound_text(claim.bound), number_text(claim.number),
             number_text(result.mutated_value), claim.mutation, verdict, claim.text);
  return result.passed();
}

int check_lessons(std::vector<std::string> names) {
  if (names.empty()) names = lesson_names();
  std::size_t claims = 0, failures = 0;
  for (const std::string& name : names) {
    const Lesson lesson = load_lesson(name);
    fmt::print("{}\n", name);
    for (const LessonStep& step : lesson.steps)
      for (const Claim& claim : step.claims) {
        ++claims;
        if (!check(claim)) ++failures;
      }
  }
  fmt::print("{} claims checked, {} failed\n", claims, failures);
  return failures == 0 ? 0 : 1;
}

}  // namespace

void add_lessons_command(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("lessons", "list, show or check the lessons");
  command->require_subcommand(0, 1);
  command->add_subcommand("list", "all lessons")->callback([&chosen] { chosen = list_lessons; });
  command->callback([&chosen] {
    if (!chosen) chosen = list_lessons;
  });

  CLI::App* show = command->add_subcommand("show", "the text of one lesson");
  const auto name = std::make_shared<std::string>();
  show->add_option("NAME", *name, "a lesson")->required();
  show->callback([&chosen, name] { chosen = [name] { return show_lesson(*name); }; });

  CLI::App* check_command =
      command->add_subcommand("check", "check the claims of the named lessons, or of all; exit status 1 if one fails");
  const auto names = std::make_shared<std::vector<std::string>>();
  check_command->add_option("NAME", *names, "lessons");
  check_command->callback([&chosen, names] { chosen = [names] { return check_lessons(*names); }; });
}

}  // namespace ps::cli
