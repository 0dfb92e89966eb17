#include "render/channel_value.h"

#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "frame/display_frame.h"

namespace ps {
namespace {

std::string triple(const Vec3d& v) { return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x, v.y, v.z); }

std::string id_text(const PixelId& id, bool with_triangle) {
  if (id.object < 0) return "nothing";
  return with_triangle ? fmt::format("object {}, triangle {}", id.object, id.triangle)
                       : fmt::format("object {}", id.object);
}

}  // namespace

bool is_heat_map(ShownChannel channel) {
  switch (channel) {
  case ShownChannel::depth:
  case ShownChannel::overdraw:
  case ShownChannel::tests:
  case ShownChannel::mip:
  case ShownChannel::samples:
  case ShownChannel::shadow:
  case ShownChannel::shadow_map:
  case ShownChannel::stencil:
    return true;
  case ShownChannel::colour:
  case ShownChannel::normal:
  case ShownChannel::barycentric:
  case ShownChannel::uv:
  case ShownChannel::triangle:
  case ShownChannel::object:
  case ShownChannel::facing:
  case ShownChannel::hit:
  case ShownChannel::direction:
  case ShownChannel::nan:
  case ShownChannel::environment:
  case ShownChannel::precision:
  case ShownChannel::depth_gap:
    return false;
  }
  return false;
}

std::optional<double> heat_value(const Frame& frame, ShownChannel channel, int x, int y) {
  switch (channel) {
  case ShownChannel::depth:
    if (const float depth = frame.depth.at(x, y); std::isfinite(depth)) return depth;
    return {};
  case ShownChannel::overdraw:
    return frame.overdraw.at(x, y);
  case ShownChannel::tests:
    return frame.tests.at(x, y);
  case ShownChannel::samples:
    return frame.samples.at(x, y);
  case ShownChannel::mip:
    if (const float level = frame.mip.at(x, y); level >= 0) return level;
    return {};
  case ShownChannel::shadow:
    if (frame.ids.at(x, y).object < 0) return {};
    return std::popcount(frame.shadow.at(x, y));
  case ShownChannel::shadow_map:
    if (const float depth = frame.shadow_map.at(x, y); depth >= 0 && std::isfinite(depth)) return depth;
    return {};
  case ShownChannel::stencil:
    return frame.stencil.at(x, y);
  case ShownChannel::colour:
  case ShownChannel::normal:
  case ShownChannel::barycentric:
  case ShownChannel::uv:
  case ShownChannel::triangle:
  case ShownChannel::object:
  case ShownChannel::facing:
  case ShownChannel::hit:
  case ShownChannel::direction:
  case ShownChannel::nan:
  case ShownChannel::environment:
  case ShownChannel::precision:
  case ShownChannel::depth_gap:
    return {};
  }
  return {};
}

std::string channel_value_text(const Frame& frame, ShownChannel channel, const Settings& settings, Vec2i pixel) {
  const int x = pixel.x;
  const int y = pixel.y;
  switch (channel) {
  case ShownChannel::colour: {
    const Rgb8 c = display_at(frame, settings, pixel);
    return fmt::format("{} {} {}", c.r, c.g, c.b);
  }
  case ShownChannel::nan:
    return triple(linear_at(frame, pixel));
  case ShownChannel::depth:
    return heat_value(frame, channel, x, y) ? fmt::format("z {:.5g}", frame.depth.at(x, y)) : "nothing";
  case ShownChannel::normal:
    return triple(Vec3d(frame.normal.at(x, y)));
  case ShownChannel::direction:
    return triple(Vec3d(frame.direction.at(x, y)));
  case ShownChannel::barycentric:
    return triple(Vec3d(frame.barycentric.at(x, y)));
  case ShownChannel::uv:
    return fmt::format("({:.4g}, {:.4g})", frame.uv.at(x, y).x, frame.uv.at(x, y).y);
  case ShownChannel::triangle:
    return id_text(frame.ids.at(x, y), true);
  case ShownChannel::object:
  case ShownChannel::hit:
    return id_text(frame.ids.at(x, y), false);
  case ShownChannel::facing:
    return fmt::format("{:.4g}", frame.facing.at(x, y));
  case ShownChannel::overdraw:
  case ShownChannel::tests:
  case ShownChannel::samples:
    return fmt::format("{}", *heat_value(frame, channel, x, y));
  case ShownChannel::mip: {
    const auto level = heat_value(frame, channel, x, y);
    return level ? fmt::format("level {:.4g}", *level) : "no texture";
  }
  case ShownChannel::shadow_map: {
    const auto depth = heat_value(frame, channel, x, y);
    if (depth) return fmt::format("depth {:.5g}", *depth);
    return frame.shadow_map.at(x, y) < 0 ? "no map here" : "sees nothing";
  }
  case ShownChannel::stencil:
    return fmt::format("{}", frame.stencil.at(x, y));
  case ShownChannel::environment: {
    const Vec3f c = frame.environment.at(x, y);
    return c.x < 0 ? "no map here" : triple(Vec3d(c));
  }
  case ShownChannel::precision:
    return std::string(precision_fault_label(frame.precision.at(x, y)));
  case ShownChannel::depth_gap: {
    const float gap = frame.depth_gap.at(x, y);
    if (std::isinf(gap)) return "no second surface";
    return fmt::format("second surface {:.4g} ulp behind", gap);
  }
  case ShownChannel::shadow: {
    const auto lights = heat_value(frame, channel, x, y);
    if (!lights) return "nothing";
    std::string text;
    for (unsigned bits = frame.shadow.at(x, y); bits != 0; bits &= bits - 1)
      text += fmt::format("{}{}", text.empty() ? "blocked: light " : ", ", std::countr_zero(bits));
    return text.empty() ? "lit" : text;
  }
  }
  return {};
}

}  // namespace ps
