#pragma once
#include <string_view>
#include <vector>

#include "math/vec.h"

namespace ps {

/// One texel of a shadow map that was compared with a point's depth.
struct ShadowTap {
  int x = 0, y = 0;   ///< texel, from the top left of the face
  double stored = 0;  ///< depth of the nearest surface that the light sees there; infinity = none
  bool lit = false;
};

/// A point was looked up in a light's shadow map (CGFS ch. 15). All depths are measured along the face's axis, from
/// the light's position, or from the plane that the map of a directional light starts at; world units.
struct ShadowMapEvent {
  int light = 0;
  int face = 0;          ///< 0..5 = +x -x +y -y +z -z; always 0 for a directional light
  bool cube = false;     ///< a point light's map
  bool outside = false;  ///< the map does not reach there: lit
  Vec2d position{0, 0};  ///< in texels, from the face's top left
  double depth = 0;      ///< of the point itself
  double bias = 0;       ///< subtracted from it before the comparison
  std::vector<ShadowTap> taps;
  double visible = 1;  ///< share of the taps that are lit
};

/// Which face of a shadow volume: what the light falls on, a side that a silhouette edge throws, or the far end.
enum class VolumePart { lit_face, side, far_end };

/// A side or cap of a shadow volume that covers the pixel.
struct VolumeCrossing {
  int object = 0;      ///< whose shadow
  bool enters = true;  ///< the line of sight goes in: a front face of the volume
  double z = 0;        ///< camera space
  int change = 0;      ///< what it did to the stencil buffer; 0 = it lay on the side that does not count
  VolumePart part = VolumePart::side;
  Vec3d edge_from{0, 0, 0}, edge_to{0, 0, 0};  ///< of a side: the silhouette edge where it begins, world space
};

/// A pixel's count in the stencil buffer of one light (CGFS ch. 15).
struct StencilEvent {
  int light = 0;
  double surface_z = 0;  ///< of the nearest surface, camera space
  std::vector<VolumeCrossing> crossings;
  int silhouette_edges = 0;  ///< of all volumes of the light
  int count = 0;             ///< sum of the changes
  int stored = 0;            ///< what the buffer holds after wrapping; 0 = lit
};

/// A mirrored direction was looked up in a cube map (CGFS ch. 15).
struct EnvironmentEvent {
  Vec3d centre{0, 0, 0};     ///< where the map was made from
  Vec3d direction{0, 0, 1};  ///< mirrored direction, not normalised
  int face = 0;              ///< 0..5 = +x -x +y -y +z -z
  Vec2d position{0, 0};      ///< in texels, from the face's top left
  Vec3d result{0, 0, 0};
  int left_out = 0;  ///< dynamic objects that the map does not show
};

/// "+x", "-x", "+y", "-y", "+z", "-z".
std::string_view cube_face_name(int face);

}  // namespace ps
