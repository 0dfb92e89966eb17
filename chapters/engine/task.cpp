#include <fmt/format.h>

#include <algorithm>

#include "base/resources.h"
#include "engine/block.h"
#include "student/own_listing.h"
#include "textbook/listing_source.h"

namespace ps {
namespace {

/// The column behind the first word of a line.
SourcePlace place_of_rest(const BlockLine& line) {
  return {line.place.file, line.place.line, line.place.column + static_cast<int>(line.word.size()) + 1};
}

}  // namespace

std::string read_task(const std::vector<BlockLine>& lines, const std::string& lesson, const SourcePlace& place) {
  const auto all = listings();
  const auto listing =
      std::find_if(all.begin(), all.end(), [&](const NamedListing& each) { return each.folder == lesson; });
  if (listing == all.end())
    throw InputError(place, "a task in a lesson without a listing of the program",
                     "tasks in the program's own lessons alone: a listing.cpp in another folder is not compiled");
  std::string routine;
  for (const BlockLine& line : lines) {
    if (line.word != "write") throw InputError(line.place, fmt::format("'{}'", line.word), "a line 'write ROUTINE'");
    if (!routine.empty()) throw InputError(line.place, "a second line 'write'", "one for each task");
    const std::vector<std::string> known = listing_routines(listing_source(*listing));
    if (std::find(known.begin(), known.end(), line.rest) == known.end())
      throw InputError(place_of_rest(line), fmt::format("the routine '{}'", line.rest),
                       fmt::format("one of the listing: {}", fmt::join(known, ", ")));
    routine = line.rest;
  }
  if (routine.empty()) throw InputError(place, "a task without words", "a line 'write ROUTINE'");
  return routine;
}

}  // namespace ps
