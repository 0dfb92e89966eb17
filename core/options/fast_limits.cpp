#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "options/rows.h"

namespace ps {
namespace {

bool is_reached(const FastLimit& limit, const Option& option, const Settings& settings, const SceneTraits& traits) {
  if (limit.in && !(traits.*limit.in)) return false;
  if (limit.reached) return limit.reached(settings, traits);
  return std::find(limit.known.begin(), limit.known.end(), option.get(settings)) == limit.known.end();
}

std::string_view needing(FastCode code) {
  switch (code) {
  case FastCode::any:
    return "needs";
  case FastCode::sphere_packets:
    return "packets need";
  case FastCode::triangle_search:
    return "SIMD searches need";
  case FastCode::hit_shading:
  case FastCode::every_hit:
  case FastCode::every_fragment:
    return "SIMD shading needs";
  case FastCode::fragment_batches:
    return "SIMD needs";
  case FastCode::whole_tiles:
    return "whole tiles need";
  }
  return "";
}

}  // namespace

void rows::say_fast_limits(Option& option) {
  for (FastLimit& limit : option.known_to.fast.list) {
    if (!limit.reason.empty()) continue;
    std::string values;
    for (const OptionNumber value : limit.known) {
      Settings settings;
      option.set(settings, value);
      values += (values.empty() ? "" : " or ") + option_text(option, settings);
    }
    limit.reason = fmt::format("{} {} = {}", needing(limit.code), option.key, values);
  }
}

std::string_view fast_limit(FastCode code, const Settings& settings, const SceneTraits& traits, int own_place,
                            std::string_view own_reason) {
  int lowest = own_reason.empty() ? std::numeric_limits<int>::max() : own_place;
  std::string_view reason = own_reason;
  for (const Option& option : option_table())
    for (const FastLimit& limit : option.known_to.fast.list)
      if (limit.code == code && limit.place < lowest && is_reached(limit, option, settings, traits)) {
        lowest = limit.place;
        reason = limit.reason;
      }
  return reason;
}

}  // namespace ps
