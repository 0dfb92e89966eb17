#pragma once
#include <string_view>

namespace ps {

/// The code path that renders a picture. In float all of them give the same bits; only the time differs, so times on
/// different paths do not compare techniques.
enum class Machinery {
  clear,             ///< scalar code that follows the sources step by step; every option works there
  sphere_packets,    ///< rays of neighbouring pixels against spheres, found and shaded by SIMD
  wide_triangles,    ///< SIMD searches for triangles; eye rays go in packets where they stay together
  fragment_batches,  ///< SIMD over the fragments of one triangle after the other
  whole_frame,       ///< SIMD from the vertices on, tile by tile
  driver,            ///< the code of the graphics driver, or its processor
};

/// How a code path shades surfaces.
enum class SurfaceShading {
  single,  ///< one hit or fragment after the other
  mixed,   ///< plain surfaces by SIMD, all others one after the other
  lanes,   ///< all by SIMD
};

/// The code path that draws a picture, and why it is not a faster one.
struct FastPath {
  Machinery machinery = Machinery::clear;
  SurfaceShading shading = SurfaceShading::single;
  std::string_view reason{};  ///< "needs precision = float"; empty for the fastest

  /// Do times of both compare what the pictures do, and not by which code?
  bool same_machinery(const FastPath& other) const { return machinery == other.machinery && shading == other.shading; }
};

/// Key for files ("whole-frame") and words for people ("SIMD, tile by tile").
std::string_view machinery_key(Machinery machinery);
std::string_view machinery_label(Machinery machinery);
std::string_view shading_key(SurfaceShading shading);

}  // namespace ps
