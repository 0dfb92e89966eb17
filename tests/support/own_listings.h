#pragma once
#include <string>
#include <string_view>

#include "student/compile_listing.h"
#include "support/environment.h"
#include "support/run_cli.h"

namespace ps::test {

/// A student's files in a folder of this test.
class OwnListings {
 public:
  OwnListings() : home_("XDG_DATA_HOME", folder_.path().string()) {}

  const ScratchFolder& folder() const { return folder_; }
  ListingPermits& permits() { return permits_; }
  /// Compiles this text as a file of the student's.
  Compilation compile(const std::string& text, const CompileOptions& options = {}) {
    return compile_listing(permits_.permit(folder_.write("own.cpp", text)), options);
  }

 private:
  ScratchFolder folder_;
  Variable home_;
  ListingPermits permits_;
};

inline const NamedListing& listing_in(std::string_view folder) {
  for (const NamedListing& listing : listings())
    if (listing.folder == folder) return listing;
  throw InputError("no listing in " + std::string(folder));
}

/// `text` with `from`, which is in it once, replaced.
inline std::string with_change(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos || text.find(from, at + 1) != std::string::npos)
    throw InputError("'" + from + "' is not in the listing, or more than once");
  return text.replace(at, from.size(), to);
}

}  // namespace ps::test
