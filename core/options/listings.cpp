#include <lessons_table.h>

#include <algorithm>

#include "options/listing.h"

namespace ps {

namespace textbook {
#define PS_DECLARE(folder) extern const Listing folder;
PS_LESSON_LISTINGS(PS_DECLARE)
#undef PS_DECLARE
#define PS_DECLARE(folder, bug, symptom) extern const Listing bug_##bug;
PS_LISTING_BUGS(PS_DECLARE)
#undef PS_DECLARE
}  // namespace textbook

namespace {

std::string spelled_with(char between, std::string name) {
  std::replace(name.begin(), name.end(), '_', between);
  return name;
}

}  // namespace

std::span<const NamedListing> listings() {
#define PS_NAMED(folder) {#folder, spelled_with('-', #folder), &textbook::folder},
  static const std::vector<NamedListing> all{PS_LESSON_LISTINGS(PS_NAMED)};
#undef PS_NAMED
  return all;
}

std::span<const ListingBug> listing_bugs() {
#define PS_BUG(folder, bug, symptom)                                                                                   \
  {#folder, #bug, spelled_with('-', #bug), spelled_with(' ', #bug), symptom, &textbook::bug_##bug},
  static const std::vector<ListingBug> all{PS_LISTING_BUGS(PS_BUG)};
#undef PS_BUG
  return all;
}

const NamedListing& listing_of(const Settings& settings, const SceneTraits& traits) {
  const auto all = listings();
  if (settings.listing > 0) return all[static_cast<std::size_t>(settings.listing) - 1];
  return *std::max_element(all.begin(), all.end(), [&](const NamedListing& a, const NamedListing& b) {
    return a.listing->suits(traits, settings) < b.listing->suits(traits, settings);
  });
}

NamedListing running_listing(const Settings& settings, const SceneTraits& traits) {
  NamedListing running = listing_of(settings, traits);
  if (settings.listing_bug == 0) return running;
  const ListingBug& bug = listing_bugs()[static_cast<std::size_t>(settings.listing_bug) - 1];
  if (bug.folder != running.folder) return running;
  running.listing = bug.listing;
  running.bug = bug.name;
  return running;
}

bool listing_reads(const NamedListing& listing, std::string_view option) {
  const auto& reads = listing.listing->reads;
  return std::find(reads.begin(), reads.end(), option) != reads.end();
}

}  // namespace ps
