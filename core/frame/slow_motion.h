#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "frame/frame.h"

namespace ps {

/// The units of slow motion: a picture can be shown as it is after n of them. The order is that of the clear path
/// on one thread.
enum class SlowUnit { triangles, fragments, pixels, rows, tiles, samples, writes };

/// The picture after the first `at` of them; more than there are: the whole picture.
struct SlowMotion {
  SlowUnit unit = SlowUnit::pixels;
  std::uint64_t at = 0;
  bool operator==(const SlowMotion&) const = default;
};

/// How a unit is called.
struct SlowUnitRow {
  SlowUnit unit{};
  std::string_view key;    ///< for files and the command line: "triangles"
  std::string_view one;    ///< in a sentence: "triangle"
  std::string_view many;   ///< "triangles"
  std::string_view label;  ///< for people: "Triangles"
  std::string_view help;   ///< one sentence: what is shown after n of them, and in which order they come
};

/// All units, in the order of the enum.
std::span<const SlowUnitRow> slow_units();
const SlowUnitRow& slow_unit(SlowUnit unit);

/// "triangles:17", which parse_slow_motion() reads back. It throws InputError for anything else.
std::string slow_motion_text(const SlowMotion& motion);
SlowMotion parse_slow_motion(std::string_view text);

/// How far slow motion has come: how many there are, and what the last one was. What does not belong to it is absent.
struct SlowState {
  SlowMotion done;                            ///< at most `total` of them
  std::uint64_t total = 0;                    ///< that the whole picture takes
  PixelId id;                                 ///< of the last triangle, or of the triangle of the last fragment
  std::vector<std::array<Vec2d, 3>> outline;  ///< that triangle, or the pieces that clipping left; pixels from top left
  std::optional<Vec2i> pixel;                 ///< the last pixel, array position
  std::optional<TileRect> box;                ///< the last row or tile
  std::string_view stage;                     ///< the walk over the triangles that it belongs to, if there are several
};

/// A picture that is not finished, and how far it has come.
struct SlowFrame {
  Frame frame;
  SlowState state;
};

/// For a picture that stores each pixel once, the state in which only the pixels of `done` are stored: the others have
/// the background's colour and in each channel the background's value. Maps, which are made before the
/// first pixel, stay as they are. Counters are absent.
Frame part_of(const Frame& whole, std::span<const TileRect> done, const Vec3d& background);
/// Stores those pixels of `from` in `to`, which has the same channels.
void copy_part(const Frame& from, std::span<const TileRect> done, Frame& to);

}  // namespace ps
