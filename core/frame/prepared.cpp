#include "frame/prepared.h"

#include <algorithm>

#include "base/available_memory.h"

namespace ps {
namespace {

/// A and B, each with a coarse and a fine picture, may need different versions of one product.
constexpr int versions_kept = 4;

/// Less than this is kept without asking what the computer can spare.
constexpr std::size_t always_kept = std::size_t{256} << 20;

/// Bytes that all products together may take.
std::size_t most_bytes(std::size_t taken) {
  const auto available = available_memory();
  return available ? usable_part(*available + taken) : taken;
}

}  // namespace

std::shared_ptr<const void> Prepared::find(const Key& key) {
  const std::lock_guard lock(mutex_);
  const auto entry = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.key == key; });
  if (entry == entries_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, entry);
  return entry->value;
}

void Prepared::keep(Entry made) {
  const std::lock_guard lock(mutex_);
  const Key& key = entries_.emplace_front(std::move(made)).key;
  int versions = 0;
  for (auto entry = entries_.begin(); entry != entries_.end();) {
    const bool same_product = entry->key.product() == key.product();
    if (same_product) ++versions;
    if (same_product && versions > versions_kept)
      entry = entries_.erase(entry);
    else
      ++entry;
  }
  std::size_t taken = 0;
  for (const Entry& entry : entries_) taken += entry.bytes();
  if (taken <= always_kept) return;
  for (const std::size_t most = most_bytes(taken); taken > most && entries_.size() > 1; entries_.pop_back())
    taken -= entries_.back().bytes();
}

std::size_t Prepared::bytes() const {
  const std::lock_guard lock(mutex_);
  std::size_t sum = 0;
  for (const Entry& entry : entries_) sum += entry.bytes();
  return sum;
}

void Prepared::clear() {
  const std::lock_guard lock(mutex_);
  entries_.clear();
}

}  // namespace ps
