#pragma once
#include <string>

#include "math/vec.h"

namespace ps {

class ObjLine;

/// The value of `refl -type`: which part of the surroundings a picture shows.
enum class ReflectionPart { none, sphere, top, bottom, front, back, left, right };

/// A picture that a material names, with its options: `map_Kd -s 2 2 1 wood panel.png`.
struct MtlTexture {
  std::string name;  ///< as written, blanks included; quotes around it are dropped
  int line = 0;
  Vec3d scale{1, 1, 1};     ///< -s: texture coordinates are multiplied by it
  Vec3d offset{0, 0, 0};    ///< -o: added to them after that
  bool turbulence = false;  ///< -t other than 0
  bool clamped = false;     ///< -clamp on: the picture does not repeat
  double base = 0;          ///< -mm: added to each texel ...
  double gain = 1;          ///< ... after it was multiplied by this
  double bump = 1;          ///< -bm: how steep heights are
  char channel = 0;         ///< -imfchan: r, g, b, m (matte, which is alpha), l (luminance) or z; 0 = not given
  ReflectionPart part = ReflectionPart::none;
};

/// Reads what follows the statement `map_Kd` and its like: options, then a name that may hold blanks or be in double
/// quotes, then perhaps more options, which some exporters write there. Throws InputError with line and column for an
/// unknown option, a wrong value and a missing name.
MtlTexture read_mtl_texture(ObjLine& line);

}  // namespace ps
