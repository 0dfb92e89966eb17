#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "frame/frame.h"
#include "raytrace/base/trace_inputs.h"

namespace ps {

inline constexpr std::size_t shaded_together = 8;

/// The fast path of shading: what eye rays of neighbouring pixels met on triangles of plain materials, eight hits at
/// once. It repeats surface_point.h and shade/illumination.h operation by operation, so every colour is the same to the
/// last bit; a test holds them together.

/// Hits, lane by lane. Lanes that hold none may hold any triangle of the scene.
struct alignas(32) HitPacket {
  using Lanes = std::array<float, shaded_together>;
  using Numbers = std::array<std::int32_t, shaded_together>;
  Numbers triangle{};    ///< index into TracedGeometry::triangles
  Numbers attributes{};  ///< index into TracedGeometry::attributes of vertex normals; -1 = the face's normal
  Numbers material{};    ///< index into HitTables::materials
  Lanes sense{};         ///< 1, or -1 for a triangle that is mirrored
  std::array<Lanes, 3> weights{}, to_eye{};
  std::array<Lanes, 3> point{}, normal{};  ///< of the surface, in world space
  std::array<Lanes, 3> colour{};           ///< the result
  /// Where meshes are shared, triangles and attributes of the lanes alone; else null: HitTables has those of the scene.
  const float *own_triangles = nullptr, *own_attributes = nullptr;
};

/// What shading reads of a material, as one row of a table.
struct HitMaterial {
  float red = 1, green = 1, blue = 1;
  float exponent = 1;  ///< of the highlight
  float faint = 0;     ///< faint_cosine() of it
  float specular = 0;  ///< 1 = the material shines and highlights are on
  float padding[2] = {0, 0};
};

struct HitTables;
/// Fills points and normals from triangles, attributes and weights.
using PlaceHits = void (*)(const HitTables& tables, HitPacket& packet);
/// Fills the colours. Bit i of blocked[k]: light k does not reach lane i.
using LightHits = void (*)(const HitTables& tables, const std::vector<unsigned>& blocked, HitPacket& packet);

/// All that stays the same for a picture.
struct HitTables {
  const float* triangles = nullptr;   ///< of the geometry, as rows of ten scalars
  const float* attributes = nullptr;  ///< likewise, rows of sixteen
  std::vector<HitMaterial> materials;
  std::vector<std::uint8_t> plain;  ///< by material: 1 = it can be shaded here
  std::vector<ShadingLight<float>> lights;
  bool lighting = true;
  bool renormalise = true;
  Highlight highlight = Highlight::phong;
  PlaceHits place = nullptr;
  LightHits light = nullptr;
};

/// The tables for a picture, or nullopt if traced_fast_path() allows no SIMD shading or no surface is plain.
std::optional<HitTables> hit_tables(const TraceInputs<float>& inputs);

/// The two functions for this setting on this processor, or none.
struct HitFunctions {
  PlaceHits place = nullptr;
  LightHits light = nullptr;
};
HitFunctions hit_functions(Simd simd);

}  // namespace ps
