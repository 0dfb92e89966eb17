#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "math/vec.h"

namespace ps {

/// Pictures that the program makes itself: "checker" (8 x 8 black and white squares), "tiles" (10 x 10 squares with a
/// colour ramp, which shows where on the picture a texel is), "bricks" and their normal map "brick-normals", "crate"
/// (planks in a frame with nails), and the gradients of a display test (CGPP 15.3.2): "gamma-checker",
/// "gamma-radiance", "gamma-brightness" and "gamma-dither".
std::vector<std::string_view> texture_generators();

/// The picture `generator` with size x size texels, size from 1 to 4096. Equal arguments give equal pictures on every
/// machine. Throws InputError for an unknown name.
Image<Vec3f> generate_texture(std::string_view generator, int size);

/// Value of Texture::generator for a picture whose file holds heights, turned into normals (image/height_map.h); and
/// their steepness read back, nullopt for any other generator.
std::string heights_generator(double steepness);
std::optional<double> heights_steepness(std::string_view generator);

}  // namespace ps
