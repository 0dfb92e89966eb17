#pragma once
#include <string_view>

#include "base/check.h"
#include "fuzz/targets.h"

namespace ps::fuzz {

/// Whether `read` came to its end or threw an InputError that says something; any other exception passes.
template <class Read>
Outcome read_or_refuse(Read read) {
  try {
    read();
    return Outcome::read;
  } catch (const InputError& error) {
    PS_ASSERT(std::string_view(error.what()) != "", "an error says what is wrong");
    return Outcome::refused;
  }
}

/// Of bytes that are a permalink, a bundle, the log of a chart, the text of a lesson, and what a student's program
/// writes.
Outcome read_permalink(std::string_view bytes);
Outcome read_bundle(std::string_view bytes);
Outcome read_log_of_chart(std::string_view bytes);
Outcome read_lesson(std::string_view bytes);
Outcome read_own_result(std::string_view bytes);

}  // namespace ps::fuzz
