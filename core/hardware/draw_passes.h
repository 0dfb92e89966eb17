#pragma once
#include <vector>

#include "hardware/picture_plan.h"

namespace ps::hardware {

/// One walk over the triangles, or with deferred shading over the pixels that show one.
struct DrawPass {
  enum class Kind {
    whole,     ///< depth test, shading, write
    depth,     ///< only the depth buffer
    geometry,  ///< depth test, and what deferred shading needs of each pixel
    shade,     ///< shades what has the buffer's depth
    light      ///< the same with a single light, or none, added to what the passes before it gave
  };
  Kind kind = Kind::whole;
  int light = -1;        ///< of Kind::light; -1: what does not depend on a light
  bool adds = false;     ///< to the picture; otherwise it replaces
  bool counted = false;  ///< the samples that it writes count as written

  bool finds_depth() const { return kind == Kind::whole || kind == Kind::depth || kind == Kind::geometry; }
  bool shades() const { return kind != Kind::depth && kind != Kind::geometry; }
};

/// The passes of a picture, in order. As the rasterizer's (raster/setup/draw_stage.h), and besides one for each light
/// where a stencil buffer or, with light computed at vertices, a shadow map holds for one light only.
std::vector<DrawPass> draw_passes(const PicturePlan& plan);

/// Are lights added up pass by pass?
bool lights_separately(const PicturePlan& plan);
/// The light of the first pass that shades: -1 where what no shadow stops has one of its own.
int first_light(const PicturePlan& plan);

}  // namespace ps::hardware
