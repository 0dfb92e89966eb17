#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/file_lock.h"

namespace ps {

/// One line of a log that holds a JSON object on each.
struct JsonLogLine {
  int number = 0;  ///< in the file, from 1
  std::string text;
  nlohmann::ordered_json json;
};

/// A line that could not be read.
struct DamagedLine {
  int number = 0;
  std::string text;
  std::string reason;  ///< "found ..., expected ..."
};

struct JsonLog {
  std::vector<JsonLogLine> lines;
  std::vector<DamagedLine> damaged;  ///< in the order of the file
};

/// Levels of braces and brackets in one line beyond which it is damaged; what studies write has 4.
inline constexpr int deepest_json_line = 32;

/// All lines of a log; empty ones do not count. A damaged line does not end the reading. Throws InputError if the file
/// cannot be read.
JsonLog read_json_log(const std::filesystem::path& path);

/// "runs.jsonl:3: found ..., expected ...", for whoever measured the log.
std::string damage_text(const std::filesystem::path& path, const DamagedLine& line);

/// Appends lines that the next version of a log leaves out to a file of the log's name with `ending`, where they are
/// kept; the name of that file. Throws InputError if it cannot be written.
std::filesystem::path keep_aside(const std::filesystem::path& path, const std::vector<std::string>& lines,
                                 const std::string& ending);

/// Makes the folder of a log if it is missing, and keeps other programs out of it as long as the lock lives. Throws
/// InputError where that fails; `doing` is what another program does there: "measuring a chart".
FileLock lock_log_folder(const std::filesystem::path& folder, std::string_view doing);

/// Throws InputError "found KEY = ..., expected ..." unless the object holds a number from `low` to `high` there.
double json_number(const nlohmann::ordered_json& object, const char* key, double low, double high);
/// The same for whole numbers.
int json_integer(const nlohmann::ordered_json& object, const char* key, int low, int high);

}  // namespace ps
