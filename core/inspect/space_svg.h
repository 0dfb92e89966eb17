#pragma once
#include <string>

#include "inspect/space_model.h"
#include "inspect/space_picture.h"

namespace ps {

struct SpaceSvgOptions {
  double least_contribution = 0;  ///< rays that bring less of the pixel's colour are left out
  int deepest_level = 3;          ///< of the accelerator's boxes
  bool nodes = false;             ///< the boxes at all
  bool grid = false;              ///< the pixel grid on the image
  bool rejected = false;          ///< triangles that never became fragments
};

/// The space view as an SVG file: the scene from outside as a pale picture, the model's items as lines over it, those
/// behind surfaces dotted.
std::string space_svg(const SpaceModel& model, const SpacePicture& picture, const SpaceSvgOptions& options = {});

}  // namespace ps
