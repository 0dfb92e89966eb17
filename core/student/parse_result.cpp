#include <fmt/format.h>

#include <array>

#include "base/foreign_text.h"
#include "student/bytes.h"
#include "student/result_bytes.h"

namespace ps {
namespace {

constexpr int last_line = 1'000'000;  // of a listing: longer ones are not read

[[noreturn]] void refuse(const std::string& found, const std::string& expected) {
  throw InputError(fmt::format("found {}, expected {}", found, expected));
}

/// A number from `first` to `last`.
int number_in(ByteReader& from, int first, int last, std::string_view what) {
  const int number = from.get<std::int32_t>();
  if (number < first || number > last)
    refuse(fmt::format("{} {}", what, number), fmt::format("one from {} to {}", first, last));
  return number;
}

std::size_t count_of(ByteReader& from, std::string_view what) {
  const auto count = from.get<std::uint32_t>();
  if (count > WatchCollector::limit)
    refuse(fmt::format("{} {}", count, what), fmt::format("at most {}", WatchCollector::limit));
  return count;
}

WatchValue get_value(ByteReader& from) {
  switch (from.get<std::uint8_t>()) {
  case 0:
    return from.get<std::uint8_t>() != 0;
  case 1:
    return from.get<std::int64_t>();
  case 2:
    return from.get<double>();
  case 3:
    return from.get<Vec2d>();
  case 4:
    return from.get<Vec3d>();
  case 5:
    return foreign_text(from.get_text(longest_watch_text));
  default:
    refuse("a value of an unknown kind", "a truth value, a number, a vector or a text");
  }
}

OwnTrace get_trace(ByteReader& from) {
  OwnTrace trace;
  const auto names = std::make_shared<std::set<std::string>>();
  const auto name = [&]() -> std::string_view {
    return *names->insert(foreign_text(from.get_text(longest_watch_name))).first;
  };
  trace.colour = from.get<Vec3d>();
  const std::size_t instances = count_of(from, "instances");
  for (std::size_t i = 0; i < instances; ++i) {
    WatchInstance instance;
    instance.line = number_in(from, 0, last_line, "line");
    instance.parent = number_in(from, -1, static_cast<int>(i) - 1, "a parent");  // so none lies in itself
    instance.name = name();
    instance.value = get_value(from);
    trace.instances.push_back(std::move(instance));
  }
  const std::size_t watches = count_of(from, "values");
  for (std::size_t i = 0; i < watches; ++i) {
    Watch watch;
    watch.line = number_in(from, 0, last_line, "line");
    watch.instance = number_in(from, -1, static_cast<int>(instances) - 1, "an instance");
    watch.name = name();
    watch.value = get_value(from);
    trace.watches.push_back(std::move(watch));
  }
  trace.dropped = from.get<std::uint64_t>();
  trace.names = names;
  return trace;
}

void require_mark(ByteReader& from, const char* place) {
  if (from.get<std::uint32_t>() != result_mark)
    refuse(fmt::format("other bytes at the {}", place), "a picture and values");
}

}  // namespace

std::uint64_t most_result_bytes(int width, int height, const ListingTask& task) {
  std::uint64_t most = 64;
  if (task.picture) most += static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) * sizeof(Vec3d);
  constexpr std::uint64_t largest_entry = 16 + longest_watch_name + longest_watch_text;
  if (task.traced) most += sizeof(Vec3d) + 2 * WatchCollector::limit * largest_entry;
  return most;
}

OwnResult parse_result(std::string_view bytes, int width, int height, const ListingTask& task) {
  ByteReader from(bytes);
  OwnResult result;
  require_mark(from, "beginning");
  const int found_width = from.get<std::int32_t>(), found_height = from.get<std::int32_t>();
  const int asked_width = task.picture ? width : 0, asked_height = task.picture ? height : 0;
  if (found_width != asked_width || found_height != asked_height)
    refuse(fmt::format("a picture of {} x {} pixels", found_width, found_height),
           fmt::format("one of {} x {}", asked_width, asked_height));
  const std::size_t pixels = static_cast<std::size_t>(asked_width) * static_cast<std::size_t>(asked_height);
  from.require(pixels, sizeof(Vec3d));
  if (task.picture) {
    result.picture = Image<Vec3d>(width, height, Unfilled{});
    from.get_all(result.picture.pixels().data(), pixels);
  }
  const bool traced = from.get<std::uint8_t>() != 0;
  if (traced != task.traced.has_value())
    refuse(traced ? "values" : "no values", traced ? "none" : "some for the pixel");
  if (traced) result.trace = get_trace(from);
  require_mark(from, "end");
  if (from.left() > 0) refuse(fmt::format("{} bytes too many", from.left()), "the end of the data");
  return result;
}

}  // namespace ps
