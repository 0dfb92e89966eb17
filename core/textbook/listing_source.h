#pragma once
#include <string>
#include <vector>

#include "options/listing.h"

namespace ps {

/// The file of a listing, or that of its variant with a bug. Throws InputError when it cannot be read.
std::string listing_source(const NamedListing& listing);

std::vector<std::string> listing_lines(const std::string& source);
/// How many lines of comment a source begins with: only a variant with a bug has one, which says what is seen.
int lines_of_head(const std::vector<std::string>& lines);

/// The line that is wrong in a variant with a bug.
struct BugLine {
  int number = 0;     ///< as in the listing, from 1
  std::string wrong;  ///< in the variant
  std::string right;  ///< in the listing
};

/// Finds it: the only line in which the variant, without its head, differs from the listing. Throws InputError if
/// there is no such line or more than one, or if the numbers of lines differ; `file` is only for the message.
BugLine bug_line(const std::string& listing, const std::string& variant, const std::string& file);
/// The same from the files of a bug.
BugLine bug_line(const ListingBug& bug);

}  // namespace ps
