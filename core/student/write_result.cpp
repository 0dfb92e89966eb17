#include <algorithm>

#include "student/bytes.h"
#include "student/result_bytes.h"

namespace ps {
namespace {

std::string_view start_of(std::string_view text, std::size_t longest) {
  return text.substr(0, std::min(text.size(), longest));
}

void put_value(ByteWriter& to, const WatchValue& value) {
  to.value(static_cast<std::uint8_t>(value.index()));
  std::visit(
      [&](const auto& v) {
        if constexpr (std::is_same_v<std::decay_t<decltype(v)>, std::string>)
          to.text(start_of(v, longest_watch_text));
        else
          to.value(v);
      },
      value);
}

}  // namespace

std::string result_bytes(const OwnResult& result) {
  ByteWriter to;
  to.value(result_mark);
  to.value(result.picture.width());
  to.value(result.picture.height());
  to.put_all(result.picture.pixels().data(), result.picture.pixels().size());
  to.value(result.trace.has_value());
  if (result.trace) {
    const OwnTrace& trace = *result.trace;
    to.value(trace.colour);
    to.value(static_cast<std::uint32_t>(trace.instances.size()));
    for (const WatchInstance& instance : trace.instances) {
      to.value(instance.line);
      to.value(instance.parent);
      to.text(start_of(instance.name, longest_watch_name));
      put_value(to, instance.value);
    }
    to.value(static_cast<std::uint32_t>(trace.watches.size()));
    for (const Watch& watch : trace.watches) {
      to.value(watch.line);
      to.value(watch.instance);
      to.text(start_of(watch.name, longest_watch_name));
      put_value(to, watch.value);
    }
    to.value(trace.dropped);
  }
  to.value(result_mark);
  return to.take();
}

}  // namespace ps
