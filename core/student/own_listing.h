#pragma once
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "options/listing.h"

/// A student's own listing: a file that begins as a copy of a lesson's listing. To compile and run it is to run a
/// program with the rights of whoever sits there, so only a person's own act may lead to it.

namespace ps {

/// A file that this person made with Pixelscope, or chose, since the program was started. Whatever compiles takes one
/// of these, and ListingPermits alone makes them.
class PermittedListing {
 public:
  const std::filesystem::path& file() const { return file_; }

 private:
  friend class ListingPermits;
  explicit PermittedListing(std::filesystem::path file) : file_(std::move(file)) {}
  std::filesystem::path file_;
};

/// Which files this person allowed in this run of the program. It is never saved.
class ListingPermits {
 public:
  /// Makes a file with listing_copy() in own_listings_folder(), under a name that is not taken. Throws InputError.
  PermittedListing copy(const NamedListing& listing, std::string_view routine = {});
  /// For a file that a person just chose by hand: in a dialog, on a command line, or by a click below the sentence that
  /// says that it will run with their rights. Throws InputError unless it is a regular file.
  PermittedListing permit(const std::filesystem::path& file);
  /// For a file whose name came in any other way (from a lesson, a scene, a permalink, a restored state): only one that
  /// was allowed before.
  std::optional<PermittedListing> find(const std::filesystem::path& file) const;

 private:
  std::set<std::filesystem::path> files_;  ///< canonical
};

/// The sentence to be read before a file of unknown origin is allowed.
std::string_view own_rights_sentence();

/// Where copies are put: XDG_DATA_HOME/pixelscope/listings, ~/.local/share by default. Throws InputError where neither
/// is known.
std::filesystem::path own_listings_folder();

/// The text of a copy of a listing, which includes textbook/listing.h alone of our headers. With a `routine`, its body
/// is left to be written: a comment, and a return of any value, so that it compiles. Throws InputError if
/// there is no such routine.
std::string listing_copy(const NamedListing& listing, std::string_view routine = {});

/// The routines of a listing's source, in their order: "intersect_ray_sphere".
std::vector<std::string> listing_routines(const std::string& source);

/// The listing that a student's file is a copy of, by the line in it that says so; nullptr if there is none.
const NamedListing* copied_listing(const std::string& source);

}  // namespace ps
