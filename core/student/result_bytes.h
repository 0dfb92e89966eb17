#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "math/vec.h"
#include "record/watch.h"
#include "student/scene_bytes.h"

/// Output of the program of a student's own listing on descriptor 3. It may write anything, by mistake or on purpose.

namespace ps {

inline constexpr std::uint32_t result_mark = 0x31525350;  ///< "PSR1": the first four bytes, and the last ones
inline constexpr std::size_t longest_watch_name = 200;    ///< bytes
inline constexpr std::size_t longest_watch_text = 2000;   ///< bytes of a value that is a text

/// The values that a student's own listing had for a pixel. Watches and instances are as those of a ListingTrace.
struct OwnTrace {
  Vec3d colour{0, 0, 0};  ///< the pixel's, 0 to 255
  std::vector<Watch> watches;
  std::vector<WatchInstance> instances;
  std::uint64_t dropped = 0;                           ///< watches beyond the limit
  std::shared_ptr<const std::set<std::string>> names;  ///< what the names above point into
};

struct OwnResult {
  Image<Vec3d> picture;  ///< colours from 0 to 255, any number and NaN too; empty if none was asked for
  std::optional<OwnTrace> trace;
};

/// The result as bytes: `names` is not used.
std::string result_bytes(const OwnResult& result);

/// The most bytes that a result of this size can have.
std::uint64_t most_result_bytes(int width, int height, const ListingTask& task);

/// Reads a result for a picture of that size. Throws InputError for everything else than what the task asked for: too
/// few bytes or too many, other sizes, counts beyond the limits, values of unknown kinds, instances that do not lie in
/// earlier ones. Memory follows from the size and the number of bytes alone.
OwnResult parse_result(std::string_view bytes, int width, int height, const ListingTask& task);

}  // namespace ps
