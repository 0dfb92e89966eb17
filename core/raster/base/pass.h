#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "base/block_store.h"
#include "frame/fast_kernels.h"
#include "frame/frame.h"
#include "frame/prepared.h"
#include "image/mip_chain.h"
#include "raster/base/clip.h"
#include "raster/base/coverage_choice.h"
#include "raster/base/edge_function.h"
#include "raster/setup/depth_format.h"
#include "raster/setup/projection.h"
#include "raster/setup/surface.h"
#include "raster/setup/textures.h"
#include "scene/scene.h"

namespace ps::raster {

struct ShadowMap;       // shadow/shadow_map.h
struct Stencil;         // shadow/stencil.h
struct EnvironmentMap;  // environment/environment_map.h

/// A vertex's place on the canvas (FixedPoint), and in `outside` one bit for each plane of Pass::planes that it lies
/// behind; no_place where it has no place in fixed point at all.
struct VertexPlace {
  static constexpr std::uint32_t no_place = 1u << 31;
  std::int32_t column = 0, row = 0;
  std::uint32_t outside = 0;
  std::uint32_t unused = 0;
};

/// An object's vertices after the vertex stage. The fourth scalar only makes them easy to read for the fast path.
template <class Real>
struct VertexBuffer {
  BlockVector<Vec4<Real>> camera;   ///< camera space; from the fast path with 1 / z
  BlockVector<Vec4<Real>> world;    ///< empty unless shading needs it; from the fast path with 1 / z
  BlockVector<Vec4<Real>> normals;  ///< world space, length 1; empty unless shading needs them
  BlockVector<VertexPlace> places;  ///< only from the fast path, and while one pixel is inspected
  /// Only from the fast path, where shading needs both and each vertex has its own normal: of every vertex the normal
  /// and then the world position, both divided by z, with 1 / z as the last number. In place of `world` and `normals`.
  BlockVector<Vec4<Real>> lit;

  /// Where few triangles ask (while one pixel is inspected, and of the fast path's those that something cuts), their
  /// vertices' world positions and normals are made from these when they are asked for, where shading needs them.
  const DrawObject* world_of = nullptr;
  const DrawObject* normals_of = nullptr;

  bool has_normals() const { return !normals.empty() || normals_of; }
};

/// Everything that stays the same while one picture is made.
template <class Real>
struct Pass {
  const Scene* scene = nullptr;
  Settings settings;
  Channel channels = Channel::none;
  Viewport<double> viewport;
  CanvasProjection<Real> projection;
  CameraSpace camera_space;
  Camera camera;
  Vec3<Real> eye{0, 0, 0};
  Vec3<Real> backward{0, 0, -1};  ///< direction to the viewer in orthographic pictures
  std::vector<ClipPlane<Real>> planes;
  CoverageGrid grid;
  CoverageChoice coverage;
  DepthCode depth;
  std::vector<ShadingLight<Real>> lights;
  std::vector<DrawObject> objects;
  std::vector<std::uint32_t> first_surface;  ///< of each object
  std::vector<Surface<Real>> surfaces;
  std::shared_ptr<const std::vector<MipChain>> textures;  ///< null where none is read

  FastPath path;  ///< what may draw the picture

  /// By light. Set by add_maps(), which fills at most one of these two.
  std::shared_ptr<const std::vector<ShadowMap>> shadow_maps;
  std::shared_ptr<const Stencil> stencil;

  /// By object. Set by add_maps(); null without environment mapping.
  std::shared_ptr<const std::vector<std::shared_ptr<const EnvironmentMap>>> environment;

  bool has_shadows() const { return shadow_maps || stencil; }
  bool perspective() const { return settings.projection == Projection::perspective; }
  /// Whether attributes are carried as value / z.
  bool divides() const { return perspective() && settings.interpolation == Interpolation::perspective; }
  /// From a surface point towards the viewer, world space, not normalised.
  Vec3<Real> to_eye(const Vec3<Real>& world) const { return perspective() ? eye - world : backward; }
};

/// +1, or -1 where a triangle of the object that turns its front to the eye runs clockwise in camera space: the
/// camera's frame mirrors the world, or the instance its model.
template <class Real>
inline double facing_sense(const Pass<Real>& pass, const DrawObject& object) {
  return object.mirrored ? -pass.camera_space.handedness : pass.camera_space.handedness;
}

template <class Real>
Pass<Real> make_pass(const Scene& scene, const View& view, const Settings& settings, Channel channels,
                     Prepared& prepared);

}  // namespace ps::raster
