#include "engine/answers.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/csv.h"
#include "base/file_lock.h"
#include "base/foreign_text.h"
#include "base/number_text.h"
#include "base/spelling.h"
#include "base/user_folder.h"
#include "record/value_text.h"

namespace ps {
namespace {

constexpr std::uintmax_t most_bytes = 16u << 20;

/// nullopt for a line that is no answer, as this program writes it.
std::optional<GivenAnswer> read_answer(const std::string& line) {
  constexpr int most_steps = 10000;
  const nlohmann::json entry = nlohmann::json::parse(line, nullptr, false);
  const auto has_text = [&](const char* key) { return entry.contains(key) && entry[key].is_string(); };
  if (!entry.is_object() || !entry.contains("step") || !entry["step"].is_number_integer()) return {};
  for (const char* key : {"time", "lesson", "question", "answer"})
    if (!has_text(key)) return {};
  if (!entry.contains("points") || !entry["points"].is_number()) return {};
  const auto step = entry["step"].get<std::int64_t>();
  const auto points = entry["points"].get<double>();
  if (step < 0 || step >= most_steps || !(points >= 0 && points <= 1)) return {};
  return GivenAnswer{entry["time"],     entry["lesson"], static_cast<int>(step),
                     entry["question"], entry["answer"], points};
}

/// A text for a field of a table: what a spreadsheet would take for a formula has a ' in front of it.
std::string plain_field(std::string text) {
  constexpr std::string_view begins_formula = "=+-@\t\r";
  const bool plain = text.empty() || begins_formula.find(text.front()) == std::string_view::npos;
  if (!plain && !parse_number(text)) text = "'" + text;
  return text;
}

/// Keeps other windows from adding an answer that would be lost when this one replaces the file.
FileLock lock_answers(const std::filesystem::path& file) {
  constexpr std::chrono::seconds patience{1};  // adding an answer takes a few milliseconds
  if (auto lock = FileLock::lock_within(FileLock::beside(file), patience)) return std::move(*lock);
  throw InputError(fmt::format("{}: another program is adding an answer there", file.string()));
}

}  // namespace

std::string answer_time() { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))); }

std::filesystem::path answers_file() {
  const auto folder = user_folder("XDG_STATE_HOME", ".local/state");
  return folder.empty() ? folder : folder / "pixelscope" / "answers.jsonl";
}

KeptAnswers kept_answers(const std::filesystem::path& file) {
  std::error_code error;
  KeptAnswers kept;
  if (file.empty() || !std::filesystem::exists(file, error)) return kept;
  std::istringstream lines(read_whole_file(file, most_bytes));
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    if (auto answer = read_answer(line))
      kept.answers.push_back(std::move(*answer));
    else
      kept.damaged.push_back(InputError({file.string(), number, 1},
                                        fmt::format("'{}'", shown_start(foreign_text(line))),
                                        "an answer, as this program writes it")
                                 .what());
  }
  return kept;
}

void keep_answer(const std::filesystem::path& file, const GivenAnswer& answer) {
  if (file.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  const FileLock lock = lock_answers(file);
  std::string text = std::filesystem::exists(file, error) ? read_whole_file(file, most_bytes) : "";
  const nlohmann::json entry{{"time", answer.time},         {"lesson", answer.lesson}, {"step", answer.step},
                             {"question", answer.question}, {"answer", answer.answer}, {"points", answer.points}};
  if (!text.empty() && !text.ends_with('\n')) text += '\n';  // what was cut off stays a line of its own
  text += entry.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  write_file_atomically(file, text);
}

std::string answers_csv(const std::vector<GivenAnswer>& answers, const std::string& student) {
  std::string table = csv_row({"student", "time", "lesson", "step", "question", "answer", "points"});
  for (const GivenAnswer& each : answers)
    table +=
        csv_row({plain_field(student), plain_field(each.time),
                 plain_field(std::filesystem::path(each.lesson).filename().string()), std::to_string(each.step + 1),
                 plain_field(each.question), plain_field(each.answer), exact_number_text(each.points)});
  return table;
}

}  // namespace ps
