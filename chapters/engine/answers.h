#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace ps {

/// A student's answer to the question of a step.
struct GivenAnswer {
  std::string time;    ///< "2026-11-25T07:12:00Z"
  std::string lesson;  ///< as Lesson::name
  int step = 0;        ///< from 0
  std::string question, answer;
  double points = 0;  ///< 0 to 1
};

/// The time now, as GivenAnswer has it.
std::string answer_time();

/// Where the answers of this user are kept from one start to the next: pixelscope/answers.jsonl in the user's state
/// folder ($XDG_STATE_HOME or ~/.local/state). Empty if there is no such folder.
std::filesystem::path answers_file();

/// The content of a file of answers.
struct KeptAnswers {
  std::vector<GivenAnswer> answers;  ///< oldest first
  std::vector<std::string> damaged;  ///< a sentence for each line that is no answer: "FILE:LINE:1: found ..."
};
/// Empty if the file is missing; empty lines do not count. Throws InputError where it cannot be read.
KeptAnswers kept_answers(const std::filesystem::path& file);
/// Adds one to the file, which is made if need be; several programs may do so at the same time. Throws InputError where
/// it cannot be read or written.
void keep_answer(const std::filesystem::path& file, const GivenAnswer& answer);

/// "student,time,lesson,step,question,answer,points", with steps from 1 and without the path of a lesson of one's own.
/// Text that a spreadsheet would take for a formula gets a quote in front.
std::string answers_csv(const std::vector<GivenAnswer>& answers, const std::string& student);

}  // namespace ps
