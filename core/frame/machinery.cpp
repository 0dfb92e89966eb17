#include "frame/machinery.h"

namespace ps {

std::string_view machinery_key(Machinery machinery) {
  switch (machinery) {
  case Machinery::clear:
    return "clear";
  case Machinery::sphere_packets:
    return "sphere-packets";
  case Machinery::wide_triangles:
    return "wide-triangles";
  case Machinery::fragment_batches:
    return "fragment-batches";
  case Machinery::whole_frame:
    return "whole-frame";
  case Machinery::driver:
    return "driver";
  }
  return "";
}

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

std::string_view shading_key(SurfaceShading shading) {
  switch (shading) {
  case SurfaceShading::single:
    return "single";
  case SurfaceShading::mixed:
    return "mixed";
  case SurfaceShading::lanes:
    return "lanes";
  }
  return "";
}

}  // namespace ps
