#pragma once
#include "image/image.h"
#include "render/render.h"

namespace ps {

/// The scene from outside, as the ground that the space view draws its lines over.
struct SpacePicture {
  View view;        ///< of the viewer, not of the picture
  double near = 1;  ///< nothing nearer is drawn, world units
  Image<Rgb8> levels;
  Image<float> depth;
  Image<PixelId> ids;
};

/// Draws the scene by the rasterizer, or what only rays can show by those.
SpacePicture draw_space_picture(const Scene& scene, const View& view, double near, Prepared& prepared,
                                Progress& progress);

/// The picture mixed with the colour of the paper, so that lines stand out; the ground is paler still.
Image<Rgb8> paled(const SpacePicture& picture, const std::vector<bool>& ground, Rgb8 paper);

}  // namespace ps
