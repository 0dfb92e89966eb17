#include "student/compile_listing.h"

#include <cstdlib>
#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/foreign_text.h"
#include "base/read_file.h"
#include "student/find_program.h"
#include "student/last_words.h"
#include "student/listing_kit.h"

namespace ps {
namespace {

constexpr std::uintmax_t largest_source = 1u << 20;  // bytes
constexpr const char* source_name = "listing.cpp";
constexpr const char* program_name = "program";

std::string path_variable() {
  const char* path = std::getenv("PATH");
  return path ? path : "/usr/local/bin:/usr/bin:/bin";
}

/// As the listings of the lessons are compiled, but for the time that optimising takes: the same bits come out.
std::vector<std::string> compiler_command(const std::filesystem::path& compiler) {
  return {compiler.string(),
          "-std=c++20",
          "-O1",
          "-ffp-contract=off",
          "-fno-math-errno",
          "-Wall",
          "-Wno-unused",
          "-fdiagnostics-color=never",
          std::string("-I") + kit_headers,
          source_name,
          "-Wl,--undefined=pixelscope_listing_main",
          kit_library,
          "-o",
          program_name};
}

/// The folder that a compiler outside the system's folders needs to see: the one that holds its bin/.
std::vector<std::filesystem::path> folders_of_compiler(const std::filesystem::path& compiler) {
  const std::filesystem::path place = std::filesystem::weakly_canonical(compiler).parent_path().parent_path();
  if (place.empty() || place == "/" || place.string().starts_with("/usr")) return {};
  return {place};
}

std::string why_no_program(const Launched& launched, const CompileOptions& options,
                           const std::vector<CompilerMessage>& messages) {
  switch (launched.end) {
  case LaunchEnd::exited:
    break;
  case LaunchEnd::signalled:
    return fmt::format("The compiler was ended by signal {}.", launched.status);
  case LaunchEnd::processor_time:
  case LaunchEnd::time:
    return fmt::format("The compiler did not end within {:.3g} s and was stopped.", options.limits.seconds);
  case LaunchEnd::memory:
    return "The compiler used more memory than it may have and was stopped.";
  case LaunchEnd::processes:
    return "The compiler started more processes than it may and was stopped.";
  case LaunchEnd::files:
    return "The compiler wrote larger files than it may and was stopped.";
  case LaunchEnd::text:
  case LaunchEnd::result:
    return "The compiler wrote too many messages and was stopped.";
  }
  if (launched.status == 0) return {};
  for (const CompilerMessage& message : messages)
    if (message.kind == MessageKind::error) return "It does not compile.";
  const std::string words = last_words(launched.text);
  return words.empty() ? fmt::format("The compiler failed without a word, with exit status {}.", launched.status)
                       : fmt::format("The compiler failed: {}", words);
}

}  // namespace

Compilation compile_listing(const PermittedListing& listing, const CompileOptions& options, const Progress* progress) {
  Compilation done;
  done.source = read_whole_file(listing.file(), largest_source);
  const std::string search_path = options.search_path ? *options.search_path : path_variable();
  const std::filesystem::path compiler = find_program({"c++", "g++", "clang++"}, search_path);
  if (compiler.empty()) {
    done.failure =
        "No C++ compiler was found: neither c++ nor g++ nor clang++ is in a folder of PATH. Install one, for "
        "example the package g++.";
    return done;
  }
  const auto program = std::make_shared<ListingProgram>();
  const std::filesystem::path folder = program->folder.empty_folder("compile");
  put_listing_kit(folder);
  write_file_atomically(folder / source_name, done.source, Durability::quick);
  give_to_nobody(folder);
  const Launch what{
      .command = compiler_command(compiler),
      .environment = {"PATH=" + search_path, "TMPDIR=" + folder.string(), "HOME=" + folder.string(), "LC_ALL=C"},
      .folder = folder,
      .input = {},
      .limits = options.limits};
  // A source's included files (.incbin, #include) are read with the compiler's rights, so it gets those of the program.
  Launched launched = launch_isolated(what, folders_of_compiler(compiler), options.isolation, progress);
  launched.text = foreign_text(launched.text);
  done.seconds = launched.seconds;
  done.messages = compiler_messages(launched.text);
  done.failure = why_no_program(launched, options, done.messages);
  program->file = folder / program_name;
  if (done.failure.empty()) done.program = program;
  return done;
}

}  // namespace ps
