#include "raster/environment/map_sources.h"

#include <algorithm>
#include <list>
#include <mutex>

namespace ps::raster {

struct MapSourceNumbers::Known {
  std::mutex mutex;
  std::list<std::pair<MapSources, std::uint64_t>> entries;  // most recently used first
};

MapSourceNumbers::MapSourceNumbers() : known_(std::make_shared<Known>()) {}

std::uint64_t MapSourceNumbers::number_of(MapSources sources) const {
  // For cube maps and a room's map as many as Prepared keeps versions of a product.
  constexpr std::size_t kept = 8;
  const std::lock_guard lock(known_->mutex);
  auto& entries = known_->entries;
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e.first == sources; });
  if (found != entries.end()) {
    entries.splice(entries.begin(), entries, found);
  } else {
    entries.emplace_front(std::move(sources), next_revision());
    if (entries.size() > kept) entries.pop_back();
  }
  return entries.front().second;
}

std::size_t MapSourceNumbers::heap_bytes() const {
  const std::lock_guard lock(known_->mutex);
  std::size_t bytes = sizeof(Known);
  for (const auto& [sources, number] : known_->entries)
    bytes +=
        sources.objects.capacity() * sizeof sources.objects[0] + sources.meshes.capacity() * sizeof sources.meshes[0];
  return bytes;
}

}  // namespace ps::raster
