#include "frame/machinery.h"

#include "base/enumerators.h"

namespace ps {

std::string_view machinery_key(Machinery machinery) { return enumerator_key(machinery); }
std::string_view shading_key(SurfaceShading shading) { return enumerator_key(shading); }

std::string_view machinery_label(Machinery machinery) {
  switch (machinery) {
  case Machinery::clear:
    return "scalar code";
  case Machinery::sphere_packets:
    return "SIMD: packets of rays against spheres";
  case Machinery::wide_triangles:
    return "SIMD: several triangles at a time";
  case Machinery::fragment_batches:
    return "SIMD: the fragments of each triangle";
  case Machinery::whole_frame:
    return "SIMD: whole tiles of the picture";
  case Machinery::driver:
    return "the graphics driver";
  }
  return "";
}

}  // namespace ps
