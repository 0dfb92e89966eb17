#include "options/rows.h"

namespace ps::rows {

std::vector<Option> renderer_rows() {
  return {
      choice<&Settings::renderer>(
          {.key = "renderer",
           .label = "Renderer",
           .help = {"Which algorithm makes the picture: one ray for each pixel, or one loop over "
                    "the pixels of each triangle.",
                    "CGFS parts I and II",
                    "Spheres are exact for rays and made of triangles for the rasterizer, so "
                    "their outlines may differ by a pixel."}},
          {{"ray-tracer", "ray tracer", "For each pixel: which surface does its ray meet first?"},
           {"rasterizer", "rasterizer", "For each triangle: which pixels does it cover?"}}),
  };
}

}  // namespace ps::rows
