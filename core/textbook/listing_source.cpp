#include "textbook/listing_source.h"

#include "base/read_file.h"
#include "base/resources.h"

namespace ps {
namespace {

constexpr std::uintmax_t largest_listing = 1u << 20;  // bytes

PatchedListing patched(const std::string& folder, const std::string& bug) {
  const std::string file = listing_bug_file(folder, bug).string();
  return patch_listing(read_whole_file(listing_file(folder), largest_listing),
                       parse_bug(read_whole_file(file, largest_listing), file), file);
}

}  // namespace

std::string listing_source(const NamedListing& listing) {
  return listing.bug.empty() ? read_whole_file(listing_file(listing.folder), largest_listing)
                             : patched(listing.folder, listing.bug).text;
}

BugLine bug_line(const ListingBug& bug) { return patched(std::string(bug.folder), std::string(bug.name)).line; }

}  // namespace ps
