#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "student/isolate.h"
#include "student/own_listing.h"
#include "student/private_folder.h"

namespace ps {

enum class MessageKind { error, warning, note };

/// The compiler's message about a line.
struct CompilerMessage {
  MessageKind kind = MessageKind::error;
  int line = 0, column = 0;  ///< of the student's file, from 1; 0 = elsewhere
  std::string text;
};

/// A student's own listing as a program. Its folder goes with it.
struct ListingProgram {
  PrivateFolder folder;
  std::filesystem::path file;  ///< the program
};

struct Compilation {
  std::string source;  ///< what was compiled
  std::vector<CompilerMessage> messages;
  std::string failure;                            ///< why there is no program, in one sentence; empty if there is one
  std::shared_ptr<const ListingProgram> program;  ///< nullptr after errors
  double seconds = 0;
};

struct CompileOptions {
  /// A compiler may take long and need much: 20 s, 2 GB.
  LaunchLimits limits{.processor_seconds = 21, .seconds = 20, .memory = std::uint64_t{2} << 30};
  std::optional<std::string> search_path{};  ///< where compilers are looked for; nullopt = PATH
  Isolation isolation = Isolation::bubblewrap_if_installed;
};

/// Compiles the file as it is now with the system's C++ compiler (c++, g++ or clang++), which runs as a child process
/// with no more rights than the program gets. What is wrong with the file or the compiler is in the result. Throws
/// Cancelled, and InputError where the file cannot be read.
Compilation compile_listing(const PermittedListing& listing, const CompileOptions& options = {},
                            const Progress* progress = nullptr);

/// Finds "listing.cpp:LINE:COLUMN: error: TEXT" and messages without a place in what a compiler or linker wrote.
std::vector<CompilerMessage> compiler_messages(const std::string& text);

}  // namespace ps
