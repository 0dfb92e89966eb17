#include "textbook/listing_source.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/resources.h"

namespace ps {
namespace {

constexpr std::uintmax_t largest_listing = 1u << 20;  // bytes

constexpr std::string_view one_line = "exactly one line that differs from listing.cpp";

}  // namespace

std::string listing_source(const NamedListing& listing) {
  return read_whole_file(listing.bug.empty() ? listing_file(listing.folder)
                                             : listing_bug_file(listing.folder, listing.bug),
                         largest_listing);
}

std::vector<std::string> listing_lines(const std::string& source) {
  std::vector<std::string> lines;
  std::size_t start = 0;
  while (start < source.size()) {
    const auto end = std::min(source.find('\n', start), source.size());
    lines.push_back(source.substr(start, end - start));
    start = end + 1;
  }
  return lines;
}

int lines_of_head(const std::vector<std::string>& lines) {
  const auto first =
      std::find_if_not(lines.begin(), lines.end(), [](const auto& line) { return line.starts_with("//"); });
  return static_cast<int>(first - lines.begin());
}

BugLine bug_line(const std::string& listing, const std::string& variant, const std::string& file) {
  const std::vector<std::string> right = listing_lines(listing);
  std::vector<std::string> wrong = listing_lines(variant);
  const int head = lines_of_head(wrong);
  wrong.erase(wrong.begin(), wrong.begin() + head);
  if (wrong.size() != right.size())
    throw InputError({file, 0, 0}, fmt::format("{} lines below its first one", wrong.size()),
                     fmt::format("{}, as in listing.cpp", right.size()));
  BugLine found;
  for (std::size_t i = 0; i < right.size(); ++i) {
    if (right[i] == wrong[i]) continue;
    const int number = static_cast<int>(i) + 1;
    if (found.number > 0)
      throw InputError({file, number + head, 1}, fmt::format("a second one after line {}", found.number + head),
                       std::string(one_line));
    found = {number, wrong[i], right[i]};
  }
  if (found.number == 0) throw InputError({file, 0, 0}, "none", std::string(one_line));
  return found;
}

BugLine bug_line(const ListingBug& bug) {
  const std::string folder(bug.folder), name(bug.name);
  return bug_line(listing_source({folder, {}, bug.listing}), listing_source({folder, {}, bug.listing, name}),
                  listing_bug_file(folder, name).string());
}

}  // namespace ps
