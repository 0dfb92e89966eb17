#pragma once
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "options/renderer_kind.h"
#include "render/render.h"
#include "study/stability/experiment.h"

namespace ps::stability {

using std::numbers::pi;
inline constexpr double nowhere = -std::numeric_limits<double>::infinity();
inline constexpr double everywhere = std::numeric_limits<double>::infinity();
inline constexpr SafeWindow nowhere_safe{everywhere, nowhere};

inline double percent(double part, double whole) { return whole > 0 ? 100 * part / whole : 0; }
inline double per_million(double part, double whole) { return whole > 0 ? 1e6 * part / whole : 0; }

/// Random numbers that are the same in every standard library.
class Random {
 public:
  explicit Random(std::uint32_t seed) : bits_(seed) {}
  /// In [0, 1), with 53 bits.
  double unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// In [0, count).
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(bits_() % count); }
  bool coin() { return (bits_() & 1) != 0; }
  /// Evenly over all directions, length 1.
  Vec3d direction() {
    const double z = between(-1, 1), angle = between(0, 2 * pi), r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }
  /// Anywhere in the cube of side 2 `half` about the origin.
  Vec3d in_cube(double half) { return {between(-half, half), between(-half, half), between(-half, half)}; }

 private:
  std::mt19937_64 bits_;
};

/// What an experiment has measured so far; each row is reported to the run's observer.
class Rows {
 public:
  explicit Rows(const StabilityRun& run) : run_(run) {}
  void add(double knob, std::string series, double naive, double robust, std::string unit) {
    rows_.push_back({knob, std::move(series), naive, robust, std::move(unit)});
    if (run_.arrived) run_.arrived(rows_.back());
    run_.check();
  }
  std::vector<StabilityRow> take() { return std::move(rows_); }

 private:
  const StabilityRun& run_;
  std::vector<StabilityRow> rows_;
};

/// The renderer of fragments, which shows both sides of everything without light.
inline Settings unlit_fragments() {
  Settings settings;
  settings.renderer = renderer_for(PictureWay::fragments);
  settings.lighting = false;
  settings.backface_culling = false;
  return settings;
}

inline Frame picture_of(const Scene& scene, const View& view, const Settings& settings, Channel channels,
                        const StabilityRun& run) {
  run.check();
  Prepared prepared;
  Progress own;
  RenderRequest request;
  request.channels = channels;
  return render(scene, view, settings, request, prepared, run.progress ? *run.progress : own);
}

}  // namespace ps::stability
