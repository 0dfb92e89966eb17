#include "frame/slow_motion.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/check.h"
#include "base/number_text.h"

namespace ps {
namespace {

constexpr SlowUnitRow unit_rows[] = {
    {SlowUnit::triangles, "triangles", "triangle", "triangles", "Triangles",
     "The picture of the scene without the later triangles; shapes on the canvas come after them."},
    {SlowUnit::fragments, "fragments", "fragment", "fragments", "Fragments",
     "Triangle after triangle, the covered pixels of each in the order of its coverage test; the picture is one tile."},
    {SlowUnit::pixels, "pixels", "pixel", "pixels", "Pixels",
     "Pixel after pixel: tile by tile, and row by row inside each tile."},
    {SlowUnit::rows, "rows", "row", "rows", "Rows",
     "Row after row from the top. Tiles come first in the kernel, but each pixel is computed alone."},
    {SlowUnit::tiles, "tiles", "tile", "tiles", "Tiles",
     "Tile after tile, row by row from the top left, each finished before the next begins."},
    {SlowUnit::samples, "samples", "sample", "samples", "Samples",
     "Every pixel is the mean of its first samples. The kernel takes all samples of a pixel before the next pixel."},
    {SlowUnit::writes, "writes", "pixel write", "pixel writes", "Pixel writes",
     "The pixels that the listing puts on the canvas, in the order of its own loops."}};

}  // namespace

std::span<const SlowUnitRow> slow_units() { return unit_rows; }

const SlowUnitRow& slow_unit(SlowUnit unit) { return unit_rows[static_cast<std::size_t>(unit)]; }

std::string slow_motion_text(const SlowMotion& motion) {
  return fmt::format("{}:{}", slow_unit(motion.unit).key, motion.at);
}

SlowMotion parse_slow_motion(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::string_view key = text.substr(0, colon);
  const auto row = std::find_if(std::begin(unit_rows), std::end(unit_rows),
                                [&](const SlowUnitRow& each) { return each.key == key; });
  const auto at = parse_integer<std::uint64_t>(colon == std::string_view::npos ? "" : text.substr(colon + 1));
  if (row == std::end(unit_rows) || !at) {
    std::string keys;
    for (const SlowUnitRow& each : unit_rows) keys += fmt::format("{}{}", keys.empty() ? "" : " ", each.key);
    throw InputError(fmt::format(
        "slow motion: found '{}', expected UNIT:N with a whole number from 0 and one of the units {}", text, keys));
  }
  return {row->unit, *at};
}

}  // namespace ps
