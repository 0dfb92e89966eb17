#include "base/block_store.h"

#include <mutex>
#include <new>
#include <vector>

namespace ps {
namespace {

constexpr std::size_t alignment = 64;
constexpr std::size_t smallest_kept = 128 << 10;  ///< what the C library takes from the system at once
constexpr std::size_t most_kept = 192 << 20;
constexpr std::size_t most_blocks = 512;

void* fresh(std::size_t bytes) { return ::operator new (bytes, std::align_val_t{alignment}); }
void release(void* block) noexcept { ::operator delete (block, std::align_val_t{alignment}); }

struct Block {
  void* place = nullptr;
  std::size_t bytes = 0;
};

struct Store {
  Store() { kept.reserve(most_blocks); }
  std::mutex mutex;
  std::vector<Block> kept;  ///< oldest first
  std::size_t bytes = 0;
};

/// Never destroyed: pictures with static lifetime give their memory back at the very end.
Store& store() {
  static Store* const only = new Store;
  return *only;
}

void drop_oldest(Store& s) noexcept {
  release(s.kept.front().place);
  s.bytes -= s.kept.front().bytes;
  s.kept.erase(s.kept.begin());
}

}  // namespace

void* take_block(std::size_t bytes) {
  if (bytes >= smallest_kept) {
    Store& s = store();
    const std::lock_guard lock(s.mutex);
    for (auto block = s.kept.rbegin(); block != s.kept.rend(); ++block) {
      if (block->bytes != bytes) continue;
      void* const place = block->place;
      s.bytes -= bytes;
      s.kept.erase(std::next(block).base());
      return place;
    }
  }
  return fresh(bytes);
}

void give_block(void* block, std::size_t bytes) noexcept {
  if (bytes < smallest_kept || bytes > most_kept) return release(block);
  Store& s = store();
  const std::lock_guard lock(s.mutex);
  while (!s.kept.empty() && (s.bytes + bytes > most_kept || s.kept.size() == most_blocks)) drop_oldest(s);
  s.kept.push_back({block, bytes});
  s.bytes += bytes;
}

std::size_t kept_block_bytes() {
  Store& s = store();
  const std::lock_guard lock(s.mutex);
  return s.bytes;
}

}  // namespace ps
