#include "inspect/parting/parting.h"

namespace ps {

std::string_view parting_cause_key(PartingCause cause) {
  switch (cause) {
  case PartingCause::none:
    return "none";
  case PartingCause::eye_ray:
    return "eye-ray";
  case PartingCause::epsilon:
    return "epsilon";
  case PartingCause::other_root:
    return "other-root";
  case PartingCause::missing_bounce:
    return "missing-bounce";
  case PartingCause::missing_shadow:
    return "missing-shadow";
  case PartingCause::precision:
    return "precision";
  case PartingCause::culling:
    return "culling";
  case PartingCause::clipping:
    return "clipping";
  case PartingCause::fill_rule:
    return "fill-rule";
  case PartingCause::coverage:
    return "coverage";
  case PartingCause::depth_tie:
    return "depth-tie";
  case PartingCause::visibility:
    return "visibility";
  case PartingCause::tessellation:
    return "tessellation";
  case PartingCause::silhouette:
    return "silhouette";
  case PartingCause::level:
    return "level";
  case PartingCause::filter:
    return "filter";
  case PartingCause::interpolation:
    return "interpolation";
  case PartingCause::shading_position:
    return "shading-position";
  case PartingCause::light_model:
    return "light-model";
  case PartingCause::texture:
    return "texture";
  case PartingCause::display:
    return "display";
  case PartingCause::planted_bug:
    return "planted-bug";
  case PartingCause::unexplained:
    return "unexplained";
  }
  return {};
}

}  // namespace ps
