#include "engine/answers.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/csv.h"
#include "base/file_lock.h"
#include "base/number_text.h"
#include "base/user_folder.h"
#include "record/value_text.h"

namespace ps {
namespace {

constexpr std::uintmax_t most_bytes = 16u << 20;

GivenAnswer read_answer(const std::string& line) {
  const nlohmann::json entry = nlohmann::json::parse(line);
  return {entry.at("time"),     entry.at("lesson"), entry.at("step"),
          entry.at("question"), entry.at("answer"), entry.at("points")};
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

std::vector<GivenAnswer> kept_answers(const std::filesystem::path& file) {
  std::error_code error;
  if (file.empty() || !std::filesystem::exists(file, error)) return {};
  std::vector<GivenAnswer> answers;
  std::istringstream lines(read_whole_file(file, most_bytes));
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    try {
      answers.push_back(read_answer(line));
    } catch (const nlohmann::json::exception&) {
      throw InputError({file.string(), number, 1}, "something else", "an answer, as this program writes it");
    }
  }
  return answers;
}

void keep_answer(const std::filesystem::path& file, const GivenAnswer& answer) {
  if (file.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  const FileLock lock = lock_answers(file);
  std::string text = std::filesystem::exists(file, error) ? read_whole_file(file, most_bytes) : "";
  const nlohmann::json entry{{"time", answer.time},         {"lesson", answer.lesson}, {"step", answer.step},
                             {"question", answer.question}, {"answer", answer.answer}, {"points", answer.points}};
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
