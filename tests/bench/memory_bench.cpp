// What the machine's memory can do: the bound for clearing and resolving pictures.

#include <cstdint>
#include <cstring>
#include <memory>

#include "bench/bench.h"

namespace ps::bench {
namespace {

/// Keeps the compiler from dropping writes that nobody reads.
void keep(const void* data) { asm volatile("" : : "r"(data) : "memory"); }

struct Buffers {
  std::vector<std::uint32_t> from, to;
};

Job clear_job(std::size_t pixels) {
  const auto buffers = std::make_shared<Buffers>();
  buffers->to.resize(2 * pixels);  // RGBA8 and float depth
  Job job;
  // Never zero: some processors clear to zero several times faster than to any other value.
  job.ours = [buffers] {
    std::memset(buffers->to.data(), 0x3f, buffers->to.size() * 4);
    keep(buffers->to.data());
  };
  job.amount = static_cast<double>(8 * pixels) * 1e-9;
  return job;
}

Job copy_job(std::size_t bytes) {
  const auto buffers = std::make_shared<Buffers>();
  buffers->from.assign(bytes / 4, 0x01020304u);
  buffers->to.assign(bytes / 4, 0x05060708u);
  Job job;
  job.ours = [buffers, bytes] {
    std::memcpy(buffers->to.data(), buffers->from.data(), bytes);
    keep(buffers->to.data());
  };
  job.amount = static_cast<double>(2 * bytes) * 1e-9;
  job.note = "read and written bytes both counted";
  return job;
}

}  // namespace

Benches memory_benches() {
  return {
      {"memory/clear/1024x768", "GB/s", "", [] { return clear_job(1024 * 768); }},
      {"memory/clear/1280x720", "GB/s", "", [] { return clear_job(1280 * 720); }},
      {"memory/clear/1920x1080", "GB/s", "", [] { return clear_job(1920 * 1080); }},
      {"memory/clear/3840x2160", "GB/s", "", [] { return clear_job(3840 * 2160); }},
      {"memory/copy/256MB", "GB/s", "", [] { return copy_job(std::size_t{256} << 20); }},
  };
}

}  // namespace ps::bench
