#pragma once
#include "cli/command.h"

namespace ps::cli {

/// `lessons handout` and `lessons new`.
void add_lesson_file_commands(CLI::App& lessons, Action& chosen);

}  // namespace ps::cli
