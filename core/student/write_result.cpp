#include <algorithm>

#include "student/bytes.h"
#include "student/result_bytes.h"

namespace ps {
namespace {

std::string_view start_of(std::string_view text, std::size_t longest) {
  return text.substr(0, std::min(text.size(), longest));
}

void put_value(ByteWriter& to, const WatchValue& value) {
  to.put(static_cast<std::uint8_t>(value.index()));
  std::visit(
      [&](const auto& v) {
        if constexpr (std::is_same_v<std::decay_t<decltype(v)>, std::string>)
          to.put_text(start_of(v, longest_watch_text));
        else
          to.put(v);
      },
      value);
}

}  // namespace

std::string result_bytes(const OwnResult& result) {
  ByteWriter to;
  to.put(result_mark);
  to.put(result.picture.width());
  to.put(result.picture.height());
  to.put_all(result.picture.pixels().data(), result.picture.pixels().size());
  to.put(result.trace.has_value());
  if (result.trace) {
    const OwnTrace& trace = *result.trace;
    to.put(trace.colour);
    to.put(static_cast<std::uint32_t>(trace.instances.size()));
    for (const WatchInstance& instance : trace.instances) {
      to.put(instance.line);
      to.put(instance.parent);
      to.put_text(start_of(instance.name, longest_watch_name));
      put_value(to, instance.value);
    }
    to.put(static_cast<std::uint32_t>(trace.watches.size()));
    for (const Watch& watch : trace.watches) {
      to.put(watch.line);
      to.put(watch.instance);
      to.put_text(start_of(watch.name, longest_watch_name));
      put_value(to, watch.value);
    }
    to.put(trace.dropped);
  }
  to.put(result_mark);
  return to.take();
}

}  // namespace ps
