#pragma once
#include <span>
#include <string>
#include <vector>

#include "options/settings.h"
#include "render/fast_path.h"

namespace ps {

/// The code path of pictures whose times are compared.
enum class MachineryRule {
  same,     ///< the same for all: if one of them cannot take the fast path, none does
  as_used,  ///< for each the fastest that can draw it, as in the window
};

/// Settings with which pictures are timed, so that their times differ by what the pictures do and not by which code
/// draws them.
struct TimedSettings {
  std::vector<Settings> settings;  ///< in the order of those given; with simd=off where some picture asks for it
  Machinery machinery = Machinery::clear;  ///< of the first
  bool same = true;                        ///< false: pictures on different paths are compared as they are
  /// For people, a sentence without its full stop: "all on scalar code, as self-hit=epsilon needs: packets need
  /// self-hit = offset".
  std::string reason;
};

/// `labels` name the settings in the reason. All of one renderer must take the same code path and shade alike; of
/// several renderers each its fastest. Where SIMD itself differs among them, and with MachineryRule::as_used, they
/// stay as they are.
TimedSettings on_same_machinery(std::span<const Settings> settings, std::span<const std::string> labels,
                                const SceneTraits& traits, MachineryRule rule = MachineryRule::same);

}  // namespace ps
