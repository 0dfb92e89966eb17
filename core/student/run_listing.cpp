#include "student/run_listing.h"

#include <fmt/format.h>
#include <signal.h>

#include <cerrno>
#include <cstring>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/foreign_text.h"
#include "student/last_words.h"

namespace ps {
namespace {

constexpr int threw = 3, no_memory = 4;  // exit statuses of student/runtime/main.cpp

std::string size_text(std::uint64_t bytes) {
  const std::uint64_t megabytes = bytes >> 20;
  return megabytes >= 1024 && megabytes % 1024 == 0 ? fmt::format("{} GB", megabytes / 1024)
                                                    : fmt::format("{} MB", megabytes);
}

std::string crash_text(int number) {
  switch (number) {
  case SIGSEGV:
  case SIGBUS:
    return "It crashed: it read or wrote memory that is not its own (SIGSEGV). Is an index or a pointer wrong?";
  case SIGFPE:
    return "It crashed: it divided a whole number by zero (SIGFPE).";
  case SIGABRT:
    return "It stopped itself (SIGABRT): a check inside it failed.";
  case SIGXFSZ:
    return "It wrote a larger file than it may and was stopped.";
  default:
    return fmt::format("It was ended by signal {}.", number);
  }
}

/// Why it did not come to its end; empty if it did.
std::string why_it_failed(const Launched& launched, const LaunchLimits& limits) {
  switch (launched.end) {
  case LaunchEnd::exited:
    if (launched.status == no_memory)
      return fmt::format("It asked for more than {} of memory.", size_text(limits.memory));
    if (launched.status == threw) return fmt::format("It threw an exception: {}", last_words(launched.text));
    if (launched.status == 0) return "";
    if (const std::string words = last_words(launched.text); words.starts_with("bwrap: "))
      return fmt::format("It could not be started: {}{}", words,
                         words.ends_with(std::strerror(EACCES)) ? folder_hint : "");
    return fmt::format("It ended early, with exit status {}.", launched.status);
  case LaunchEnd::signalled:
    return crash_text(launched.status);
  case LaunchEnd::processor_time:
    return fmt::format("It used more than {:.3g} s of processor time and was stopped. Does a loop never end? If all of "
                       "them do, choose a smaller picture size or a scene with fewer triangles.",
                       limits.processor_seconds);
  case LaunchEnd::time:
    return fmt::format("It did not end within {:.3g} s and was stopped.", limits.seconds);
  case LaunchEnd::memory:
    return fmt::format("It used more than {} of memory and was stopped.", size_text(limits.memory));
  case LaunchEnd::processes:
    return fmt::format("It started more than {} processes and was stopped.", limits.processes);
  case LaunchEnd::files:
    return fmt::format("It wrote more than {} of files and was stopped.", size_text(limits.file_bytes));
  case LaunchEnd::text:
    return fmt::format("It printed more than {} and was stopped.", size_text(limits.text_bytes));
  case LaunchEnd::result:
    return "It wrote more than a picture and its values, and was stopped.";
  }
  return {};
}

}  // namespace

OwnRun run_listing(const ListingProgram& program, const BookScene& scene, const ListingTask& task,
                   const RunOptions& options, const Progress* progress) {
  const PrivateFolder place;  // of this run: two may go on at once
  const std::filesystem::path folder = place.empty_folder("run"), input = place.path() / "scene";
  give_to_nobody(folder);
  write_file_atomically(input, scene_bytes(scene, task), Durability::quick);
  Launch what{.command = {program.file.string()},
              .environment = {},
              .folder = folder,
              .input = input,
              .limits = options.limits};
  what.limits.result_bytes = most_result_bytes(scene.width, scene.height, task);
  Launched launched = launch_isolated(what, {program.file}, options.isolation, progress);
  OwnRun run;
  run.seconds = launched.seconds;
  run.text = foreign_text(launched.text);
  launched.text = run.text;
  run.text_cut = launched.text_cut;
  run.failure = why_it_failed(launched, options.limits);
  if (!run.failure.empty()) return run;
  if (launched.result.empty()) {
    run.failure = "It ended before its picture was complete.";
    return run;
  }
  try {
    run.result = parse_result(launched.result, scene.width, scene.height, task);
  } catch (const InputError& error) {
    run.failure = fmt::format("What it wrote is not its picture: {}.", error.what());
  }
  return run;
}

}  // namespace ps
