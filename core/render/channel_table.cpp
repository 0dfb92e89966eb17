#include <array>

#include <fmt/format.h>

#include "base/check.h"
#include "render/channel_picture.h"

namespace ps {
namespace {

const std::array<ShownChannelRow, 21> rows{{
    {ShownChannel::colour, "colour", "Colour", "The picture itself.", Channel::none, ""},
    {ShownChannel::depth, "depth", "Depth", "Distance in front of the camera along its forward axis.", Channel::depth,
     "world units"},
    {ShownChannel::normal, "normal", "Normal", "Shading normal: x, y, z from -1 to 1 as red, green, blue.",
     Channel::normal, ""},
    {ShownChannel::barycentric, "barycentric", "Barycentric", "Weights of the triangle's vertices as red, green, blue.",
     Channel::barycentric, ""},
    {ShownChannel::uv, "uv", "Texture coordinates", "Fractional parts of u and v as red and green.", Channel::uv, ""},
    {ShownChannel::triangle, "triangle", "Triangle", "One colour for each triangle.", Channel::ids, ""},
    {ShownChannel::object, "object", "Object", "One colour for each object.", Channel::ids, ""},
    {ShownChannel::facing, "facing", "Facing", "Blue: front side. Orange: back side. Pale: seen edge-on.",
     Channel::facing, ""},
    {ShownChannel::overdraw, "overdraw", "Overdraw", "Number of fragments that covered the pixel.", Channel::overdraw,
     "fragments"},
    {ShownChannel::tests, "tests", "Tests", "Number of primitives or samples that were tested for the pixel.",
     Channel::tests, "tests"},
    {ShownChannel::mip, "mip", "Mip level", "Mip level at which the texture was read.", Channel::mip, "level"},
    {ShownChannel::samples, "samples", "Samples", "Number of samples that were averaged for the pixel.",
     Channel::samples, "samples"},
    {ShownChannel::shadow, "shadow", "Shadows", "Number of lights that are blocked at the point.",
     Channel::shadow | Channel::ids, "lights"},
    {ShownChannel::hit, "hit", "Hit", "White where the pixel shows an object.", Channel::ids, ""},
    {ShownChannel::direction, "direction", "Eye rays",
     "Direction of the eye ray: x, y, z from -1 to 1 as red, green, blue.", Channel::direction, ""},
    {ShownChannel::nan, "nan", "NaN", "Magenta where a colour is not a number, orange where it is infinite.",
     Channel::none, ""},
    {ShownChannel::shadow_map, "shadow-map", "Shadow maps",
     "The shadow maps of the lights, side by side: distance from the light to the nearest surface in each texel.",
     Channel::shadow_map, "world units"},
    {ShownChannel::stencil, "stencil", "Stencil", "Counters of the stencil buffers, summed over the lights; 0 = lit.",
     Channel::stencil, "volumes"},
    {ShownChannel::environment, "environment", "Environment map",
     "The cube map of the first reflective object, unfolded.", Channel::environment, ""},
    {ShownChannel::precision, "precision", "Precision",
     "The picture compared with a rendering in double: pixels that differ, by kind of error. The rest is dimmed.",
     Channel::precision | Channel::ids, ""},
    {ShownChannel::depth_gap, "depth-gap", "Depth gap",
     "Gap between the first and the second surface, in units in the last place (ulp) of the stored depth.",
     Channel::depth_gap, "ulp of stored depth (log scale)"},
}};

}  // namespace

std::span<const ShownChannelRow> shown_channels() { return rows; }

const ShownChannelRow& shown_channel(ShownChannel channel) {
  const ShownChannelRow& row = rows.at(static_cast<std::size_t>(channel));
  PS_ASSERT(row.channel == channel, "rows are in the order of the enum");
  return row;
}

ShownChannel parse_shown_channel(std::string_view key) {
  std::string keys;
  for (const ShownChannelRow& row : rows) {
    if (row.key == key) return row.channel;
    keys += keys.empty() ? "" : " ";
    keys += row.key;
  }
  throw InputError(fmt::format("show: found \"{}\", expected one of: {}", key, keys));
}

}  // namespace ps
