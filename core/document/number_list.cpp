#include "document/number_list.h"

#include <fmt/format.h>

#include <array>

#include "base/check.h"
#include "base/number_text.h"
#include "image/image.h"

namespace ps {

std::string number_list_text(std::span<const double> numbers) {
  std::string text;
  for (const double number : numbers) text += fmt::format("{}{}", text.empty() ? "" : ",", number);
  return text;
}

std::vector<double> parse_number_list(std::string_view text, std::size_t count, std::string_view what) {
  std::vector<double> numbers;
  std::string_view rest = text;
  while (true) {
    const auto comma = rest.find(',');
    const auto number = parse_number(rest.substr(0, comma));
    if (!number) break;
    numbers.push_back(*number);
    if (comma == std::string_view::npos) {
      if (numbers.size() == count) return numbers;
      break;
    }
    rest.remove_prefix(comma + 1);
  }
  throw InputError(fmt::format("{}: found '{}', expected {} numbers with commas between them", what, text, count));
}

std::string camera_text(const Camera& c) {
  const std::array<double, 15> numbers{c.position.x,
                                       c.position.y,
                                       c.position.z,
                                       c.right.x,
                                       c.right.y,
                                       c.right.z,
                                       c.up.x,
                                       c.up.y,
                                       c.up.z,
                                       c.forward.x,
                                       c.forward.y,
                                       c.forward.z,
                                       c.viewport_width,
                                       c.viewport_height,
                                       c.projection_plane_d};
  return number_list_text(numbers);
}

Camera parse_camera_text(std::string_view text) {
  const auto n = parse_number_list(text, 15, "camera");
  Camera camera{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}, {n[9], n[10], n[11]}, n[12], n[13], n[14]};
  if (!(camera.viewport_width > 0 && camera.viewport_height > 0 && camera.projection_plane_d > 0))
    throw InputError("camera: the last three numbers (viewport size and distance) must be above 0");
  return camera;
}

Vec2i parse_size_text(std::string_view text) {
  const auto x = text.find('x');
  if (x != std::string_view::npos) {
    const auto width = parse_integer<std::int64_t>(text.substr(0, x));
    const auto height = parse_integer<std::int64_t>(text.substr(x + 1));
    if (width && height) {
      require_image_size(*width, *height, "picture size");
      return {static_cast<int>(*width), static_cast<int>(*height)};
    }
  }
  throw InputError(fmt::format("size: found '{}', expected WIDTHxHEIGHT", text));
}

Vec2i parse_pixel_text(std::string_view text) {
  const auto comma = text.find(',');
  if (comma != std::string_view::npos) {
    const auto x = parse_integer<int>(text.substr(0, comma));
    const auto y = parse_integer<int>(text.substr(comma + 1));
    if (x && y && *x >= 0 && *y >= 0) return {*x, *y};
  }
  throw InputError(fmt::format("pixel: found '{}', expected COLUMN,ROW", text));
}

std::string region_text(const TileRect& region) {
  return fmt::format("{},{},{},{}", region.x0, region.y0, region.width(), region.height());
}

TileRect parse_region_text(std::string_view text) {
  constexpr int most = 1 << 20;  // pixels: more than any picture has on a side
  std::array<int, 4> numbers{};
  std::string_view rest = text;
  bool good = true;
  for (std::size_t i = 0; i < numbers.size() && good; ++i) {
    const auto comma = rest.find(',');
    const auto number = parse_integer<int>(rest.substr(0, comma));
    good = number && *number >= 0 && *number <= most && (comma == std::string_view::npos) == (i + 1 == numbers.size());
    if (!good) break;
    numbers[i] = *number;
    if (comma != std::string_view::npos) rest.remove_prefix(comma + 1);
  }
  const auto [x, y, width, height] = numbers;
  if (!good || width < 1 || height < 1)
    throw InputError(fmt::format("region: found '{}', expected X,Y,W,H in pixels", text));
  return {x, y, x + width, y + height};
}

}  // namespace ps
