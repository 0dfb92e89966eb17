#include <lessons_table.h>

#include <algorithm>

#include "options/listing.h"

namespace ps {

namespace textbook {
#define PS_DECLARE(folder) extern const Listing folder;
PS_LESSON_LISTINGS(PS_DECLARE)
#undef PS_DECLARE
}  // namespace textbook

namespace {

std::string kebab(std::string folder) {
  std::replace(folder.begin(), folder.end(), '_', '-');
  return folder;
}

}  // namespace

std::span<const NamedListing> listings() {
#define PS_NAMED(folder) {#folder, kebab(#folder), &textbook::folder},
  static const std::vector<NamedListing> all{PS_LESSON_LISTINGS(PS_NAMED)};
#undef PS_NAMED
  return all;
}

const NamedListing& listing_of(const Settings& settings, const SceneTraits& traits) {
  const auto all = listings();
  if (settings.listing > 0) return all[static_cast<std::size_t>(settings.listing) - 1];
  return *std::max_element(all.begin(), all.end(), [&](const NamedListing& a, const NamedListing& b) {
    return a.listing->suits(traits, settings) < b.listing->suits(traits, settings);
  });
}

bool listing_reads(const NamedListing& listing, std::string_view option) {
  const auto& reads = listing.listing->reads;
  return std::find(reads.begin(), reads.end(), option) != reads.end();
}

}  // namespace ps
