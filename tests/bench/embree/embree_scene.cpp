#include "bench/embree/embree_scene.h"

#include <fmt/core.h>

#include "base/check.h"

namespace ps::bench {
namespace {

RTCRay to_embree(const BenchRay& ray) {
  RTCRay result;
  result.org_x = ray.origin.x;
  result.org_y = ray.origin.y;
  result.org_z = ray.origin.z;
  result.tnear = 0;
  result.dir_x = ray.direction.x;
  result.dir_y = ray.direction.y;
  result.dir_z = ray.direction.z;
  result.time = 0;
  result.tfar = ray.t_max;
  result.mask = 0xffffffffu;
  result.id = 0;
  result.flags = 0;
  return result;
}

}  // namespace

EmbreeScene::EmbreeScene(const Mesh& mesh, EmbreeMode mode, int threads)
    : device_(rtcNewDevice(fmt::format("threads={}", threads).c_str())) {
  if (!device_) throw InputError("Embree cannot be started");
  geometry_ = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* positions = static_cast<Vec3f*>(rtcSetNewGeometryBuffer(geometry_, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                sizeof(Vec3f), mesh.positions.size()));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) positions[i] = Vec3f(mesh.positions[i]);
  using Corners = std::array<std::uint32_t, 3>;
  auto* corners = static_cast<Corners*>(rtcSetNewGeometryBuffer(geometry_, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                sizeof(Corners), mesh.triangles.size()));
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) corners[i] = mesh.triangles[i].position;
  rtcCommitGeometry(geometry_);
  scene_ = rtcNewScene(device_);
  if (mode == EmbreeMode::robust) rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
  rtcAttachGeometry(scene_, geometry_);
  rtcCommitScene(scene_);
  if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) throw InputError("Embree refuses the mesh");
}

EmbreeScene::~EmbreeScene() {
  rtcReleaseScene(scene_);
  rtcReleaseGeometry(geometry_);
  rtcReleaseDevice(device_);
}

void EmbreeScene::nearest(std::span<const BenchRay> rays, std::span<BenchHit> hits) const {
  embree::Query context;
  embree::begin(context);
  RTCRayHit query;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    query.ray = to_embree(rays[i]);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    embree::nearest(scene_, context, query);
    const bool found = query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    hits[i] = {found ? query.hit.primID : no_hit, query.ray.tfar};
  }
}

void EmbreeScene::any(std::span<const BenchRay> rays, std::span<BenchHit> hits) const {
  embree::Query context;
  embree::begin(context);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    RTCRay query = to_embree(rays[i]);
    embree::any(scene_, context, query);
    hits[i] = {query.tfar < 0 ? 0 : no_hit, 0};  // Embree marks a blocked ray with -infinity
  }
}

void EmbreeScene::rebuild() {
  // A new scene: committing the old one again would find nothing to do.
  const RTCSceneFlags flags = rtcGetSceneFlags(scene_);
  rtcReleaseScene(scene_);
  scene_ = rtcNewScene(device_);
  rtcSetSceneFlags(scene_, flags);
  rtcAttachGeometry(scene_, geometry_);
  rtcCommitScene(scene_);
}

}  // namespace ps::bench
