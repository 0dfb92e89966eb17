#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/parallel.h"
#include "scene/camera.h"

namespace ps {

/// "1,0.5,-2": each number in the shortest form that reads back exactly.
std::string number_list_text(std::span<const double> numbers);
/// Reads exactly `count` finite numbers separated by commas. `what` names them in the InputError.
std::vector<double> parse_number_list(std::string_view text, std::size_t count, std::string_view what);

/// A camera as 15 numbers: position, right, up, forward, viewport width and height, projection plane distance.
std::string camera_text(const Camera& camera);
Camera parse_camera_text(std::string_view text);

/// "640x480" with both sides at least 1 and the picture within max_image_pixels; else InputError.
Vec2i parse_size_text(std::string_view text);
/// "312,204": whole numbers, 0 or more.
Vec2i parse_pixel_text(std::string_view text);
/// "10,20,300,200": column and row of the top left pixel, 0 or more, then width and height, 1 or more.
std::string region_text(const TileRect& region);
TileRect parse_region_text(std::string_view text);

}  // namespace ps
