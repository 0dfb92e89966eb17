#pragma once
#include <array>
#include <span>
#include <vector>

#include "base/counters.h"
#include "base/parallel.h"
#include "frame/frame.h"
#include "raytrace/base/trace_inputs.h"

namespace ps {

/// The fast path for the common case: a few spheres, float, the default intersection settings, and only the colour
/// asked for. One instruction works on the rays of 4, 8 or 16 neighbouring pixels. It repeats the clear path (tracer.h)
/// operation by operation, so the picture and the counters are the same to the last bit; a test holds them together.

struct PacketSphere {
  PixelId id;
  float x = 0, y = 0, z = 0, radius = 1;
  float eye_c = 0;  ///< |eye - centre|^2 - radius^2, as the robust sphere test computes it
  Vec3f colour{1, 1, 1};
  float reflective = 0;
  float exponent = 1;  ///< of the highlight
  float faint = 0;     ///< faint_cosine() of it
  bool specular = false;
};

/// The scene as packets of rays read it.
struct PacketScene {
  std::vector<PacketSphere> spheres;  ///< in the order of the scene
  std::vector<ShadingLight<float>> lights;
  Viewport<float> viewport;
  Vec3f eye{0}, right{0}, up{0}, forward{0};
  Vec3f background{0};
  float near = 0, far = 0;
  int depth = 0;     ///< bounces
  float cutoff = 0;  ///< share of the pixel that a bounce brings at least
  bool lighting = true, highlights = true, shadows = true, any_hit = true;
  bool useful_only = false;  ///< shadow rays only to lights that add something
  bool tree = false;         ///< the clear path would visit one tree node for each ray
  int step = 1;              ///< of subsampling, in pixels; 1 = each pixel is searched for
};

/// Do the squares of all its numbers keep their digits? Packets have no other way.
bool suits_packets(const TraceInputs<float>& inputs);

/// The scene for the fast path; only where traced_fast_path() allows it.
PacketScene packet_scene(const TraceInputs<float>& inputs);

/// The pixels `part` of a tile.
using TracePackets = void (*)(const PacketScene& scene, const TileRect& tile, const TileRect& part, Frame& frame,
                              Counters& counters);

/// A ray through any point of a pixel: offset from its top-left corner.
struct PacketSample {
  int column = 0, row = 0;
  float offset_x = 0.5f, offset_y = 0.5f;
};

/// What such a ray brought back.
struct PacketResult {
  Vec3f colour{0};
  float t = 0;
  int sphere = -1;  ///< index into PacketScene::spheres; -1 = background
};

using TraceSamples = void (*)(const PacketScene& scene, std::span<const PacketSample> samples,
                              std::span<PacketResult> results, Counters& counters);

struct PacketFunctions {
  TracePackets tile = nullptr;  ///< each pixel of a tile one ray through its sample position
  TraceSamples samples = nullptr;
};

/// The functions for this setting on this processor; nullptr means the clear path. A target that the processor lacks
/// gives the best one below it.
PacketFunctions packet_functions(Simd simd);

}  // namespace ps
