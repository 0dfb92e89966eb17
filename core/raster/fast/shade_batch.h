#pragma once
#include <array>
#include <cmath>
#include <span>

#include "math/vec.h"
#include "options/settings.h"
#include "raster/fast/packed_texture.h"
#include "shade/faint_highlight.h"
#include "shade/shading_inputs.h"

namespace ps::raster {

/// The fast path of shading: perspective-correct pictures in float, for many visible fragments of one surface at once.
/// It repeats shade_fragment.h and shade/illumination.h operation by operation, so every colour is the same to the last
/// bit; a test holds them together.
struct ShadeBatch {
  static constexpr int capacity = 512;
  static constexpr std::size_t room = capacity + 16;  ///< whole vectors are written
  using Lanes = std::array<float, room>;
  int count = 0;
  std::uint64_t texels = 0;                           ///< read so far
  alignas(64) std::array<std::int32_t, room> pixels;  ///< index into the picture, row by row
  alignas(64) std::array<Lanes, 3> weights;           ///< on the screen
  alignas(64) Lanes z;
  alignas(64) Lanes red, green, blue;  ///< the result
};

/// Where the light on a fragment comes from.
enum class BatchLight { none, equation, corners, constant };

/// What the fragments of a batch share.
struct BatchShading {
  const float* attributes = nullptr;  ///< of vertex 0, carried as value / z; vertices follow each other
  int stride = 0;                     ///< scalars of a vertex
  // What differs from triangle to triangle may be behind its vertices.
  int face_normal_at = -1;         ///< -1 = face_normal
  int steps_at = -1;               ///< BatchTexture::steps, each followed by a number without meaning; -1 = those
  int normal = -1, position = -1;  ///< first scalar of each; -1 = face_normal, and the origin
  int light = -1;                  ///< first scalar of the vertices' light (Gouraud)
  BatchLight source = BatchLight::equation;
  Vec3f constant{0, 0, 0};  ///< the light of the whole triangle (flat)
  Vec3f face_normal{0, 0, 1};
  Vec3f eye{0, 0, 0};
  Vec3f colour{1, 1, 1};
  float exponent = 1;
  float faint = 0;        ///< no cosine up to here is 2^-38 or more when raised; see faint_cosine()
  bool specular = false;  ///< the material shines and highlights are on
  bool renormalise = true;
  Highlight highlight = Highlight::phong;
  std::span<const ShadingLight<float>> lights;
  BatchTexture texture;
};

/// Shades all fragments of the batch, which are of one triangle. May overwrite the colours that follow.
using ShadeFragments = void (*)(const BatchShading& shading, ShadeBatch& batch);

/// The function for this setting on this processor; nullptr means the clear path. A target that the processor lacks
/// gives the best one below it.
ShadeFragments shade_function(Simd simd);

}  // namespace ps::raster
