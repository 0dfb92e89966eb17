#pragma once
#include <memory>
#include <optional>

#include "raytrace/base/trace_inputs.h"
#include "raytrace/fast/wide_geometry.h"
#include "raytrace/fast/wide_instances.h"
#include "raytrace/fast/wide_packet.h"
#include "raytrace/fast/wide_search.h"

namespace ps {

/// Inputs of the SIMD searches besides TraceInputs, made once for each picture: one of the three geometries, with
/// the functions for the triangle test on this processor.
struct WideInputs {
  /// The accelerator's triangles. A search finds the hits of the clear path, but visits nodes of its own.
  std::shared_ptr<const WideGeometry> wide;
  std::shared_ptr<const ListGeometry> list;        ///< with accelerator = none
  std::shared_ptr<const WideInstances> instances;  ///< with accelerator = two-level
  bool only_triangles = false;                     ///< the scene holds nothing else
  SeenFrom<float> seen;                            ///< how boxes are seen
  WideSearches searches;
  InstanceSearches instance_searches;
  PacketSearches packets;  ///< for rays of neighbouring pixels in `wide`; may be missing
};

/// nullopt where traced_fast_path() allows no such search, or where no triangle has an area.
std::optional<WideInputs> wide_inputs(const Scene& scene, const TraceInputs<float>& inputs, Prepared& prepared);

}  // namespace ps
