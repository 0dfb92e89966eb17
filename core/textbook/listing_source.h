#pragma once
#include <string>

#include "options/listing.h"
#include "textbook/bug_patch.h"

namespace ps {

/// The text of a listing, with its bug if it names one. Throws InputError when a file cannot be read, or as
/// patch_listing() does.
std::string listing_source(const NamedListing& listing);

/// The wrong line of a bug. Throws InputError as patch_listing() does.
BugLine bug_line(const ListingBug& bug);

}  // namespace ps
