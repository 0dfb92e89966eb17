#pragma once
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "options/settings.h"
#include "scene/scene.h"

namespace ps {

/// Values in the form that all kinds share: booleans 0/1, choices by index, integers and reals as they are.
using OptionNumber = double;

/// In a row: all values alike.
struct AnyValue {};

/// SIMD code, each part of which knows fewer options than the scalar code.
enum class FastCode {
  any,               ///< all of it
  sphere_packets,    ///< packets of rays against spheres
  triangle_search,   ///< the search for triangles that rays hit
  hit_shading,       ///< shading of such hits
  every_hit,         ///< shading of all of them
  fragment_batches,  ///< several fragments of a triangle at a time
  every_fragment,    ///< shading of all of them
  whole_tiles        ///< all triangles of a tile at once
};

/// Whole tiles have edge functions of 32 bits, and so at most this many sub-pixel bits (raster/fast/assembly.h).
inline constexpr int fast_subpixel_bits = 8;

/// Values of an option that some SIMD code does not know, so that slower code draws.
struct FastLimit {
  FastCode code;
  int place;                          ///< of several limits that are reached, the one of the lowest place is named
  std::vector<OptionNumber> known{};  ///< values that it knows; empty: see `reached`
  bool SceneTraits::*in = nullptr;    ///< the limit holds in such scenes alone; null: in all
  bool (*reached)(const Settings&, const SceneTraits&) = nullptr;  ///< in place of `known`
  std::string reason{};  ///< empty in a row: the table says "packets need self-hit = offset"

  FastLimit where(bool SceneTraits::*trait) && {
    in = trait;
    return std::move(*this);
  }
  FastLimit said(std::string_view words) && {
    reason = words;
    return std::move(*this);
  }
};

/// The limits of an option.
struct FastLimits {
  FastLimits() = delete;
  FastLimits(AnyValue) {}
  FastLimits(std::initializer_list<FastLimit> all) : list(all) {}
  std::vector<FastLimit> list{};
};

/// Why this code cannot draw with these settings and this scene: of the limits of all options, and of the one given,
/// the reason of the lowest place. Empty if none is reached.
std::string_view fast_limit(FastCode code, const Settings& settings, const SceneTraits& traits, int own_place = 0,
                            std::string_view own_reason = {});

}  // namespace ps
