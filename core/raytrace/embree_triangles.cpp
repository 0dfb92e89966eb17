#include "raytrace/embree_triangles.h"

#include <atomic>

#include "base/check.h"
#include "base/stop.h"

#ifdef PIXELSCOPE_EMBREE
#include <embree3/rtcore.h>

namespace ps {

struct EmbreeTriangles::Content {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<std::uint32_t> primitives;  ///< of Embree's triangles
  std::atomic<std::int64_t> bytes{0};

  ~Content() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
};

namespace {

/// What a filter function gets to know of the query: Embree hands this back.
struct Context {
  RTCIntersectContext embree;
  const std::uint32_t* primitives;
  void* data;
  bool (*visit)(void* data, const EmbreeCandidate& candidate);
};

void filter(const RTCFilterFunctionNArguments* arguments) {
  const auto& context = *reinterpret_cast<const Context*>(arguments->context);
  for (unsigned i = 0; i < arguments->N; ++i) {
    if (arguments->valid[i] == 0) continue;
    const float u = RTCHitN_u(arguments->hit, arguments->N, i), v = RTCHitN_v(arguments->hit, arguments->N, i);
    const EmbreeCandidate candidate{context.primitives[RTCHitN_primID(arguments->hit, arguments->N, i)],
                                    RTCRayN_tfar(arguments->ray, arguments->N, i),
                                    {1 - u - v, u, v}};
    if (!context.visit(context.data, candidate)) arguments->valid[i] = 0;
  }
}

/// Embree calls it while it builds a tree; false ends that.
bool goes_on(void* progress, double) { return !static_cast<const Progress*>(progress)->stop_requested(); }

bool count_bytes(void* total, ssize_t bytes, bool) {
  *static_cast<std::atomic<std::int64_t>*>(total) += bytes;
  return true;
}

}  // namespace

EmbreeTriangles::EmbreeTriangles(const TracedGeometry<float>& geometry) : content_(std::make_unique<Content>()) {
  Content& my = *content_;
  my.device = rtcNewDevice("threads=1");  // more would build another tree each time, and count other tests
  if (!my.device) throw InputError("Embree cannot be started");
  rtcSetDeviceMemoryMonitorFunction(my.device, count_bytes, &my.bytes);
  for (std::uint32_t i = 0; i < geometry.primitives.size(); ++i)
    if (geometry.primitives[i].kind == PrimitiveKind::triangle) my.primitives.push_back(i);
  const std::size_t count = my.primitives.size();
  RTCGeometry triangles = rtcNewGeometry(my.device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* positions = static_cast<Vec3f*>(
      rtcSetNewGeometryBuffer(triangles, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3f), 3 * count));
  auto* corners = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(triangles, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), count));
  if (positions != nullptr && corners != nullptr) {
    for (std::size_t i = 0; i < count; ++i) {
      const TracedTriangle<float>& triangle = geometry.triangles[geometry.primitives[my.primitives[i]].shape];
      positions[3 * i] = triangle.a;
      positions[3 * i + 1] = triangle.b;
      positions[3 * i + 2] = triangle.c;
      for (std::size_t k = 0; k < 3; ++k) corners[3 * i + k] = static_cast<std::uint32_t>(3 * i + k);
    }
    rtcSetGeometryIntersectFilterFunction(triangles, filter);
    rtcSetGeometryOccludedFilterFunction(triangles, filter);
    rtcCommitGeometry(triangles);
    my.scene = rtcNewScene(my.device);
    rtcSetSceneFlags(my.scene, RTC_SCENE_FLAG_ROBUST);
    rtcAttachGeometry(my.scene, triangles);
    const Progress* stop = current_stop();
    if (stop) rtcSetSceneProgressMonitorFunction(my.scene, goes_on, const_cast<Progress*>(stop));
    rtcCommitScene(my.scene);
    if (stop) rtcSetSceneProgressMonitorFunction(my.scene, nullptr, nullptr);
  }
  rtcReleaseGeometry(triangles);
  check_stop();
  if (rtcGetDeviceError(my.device) != RTC_ERROR_NONE) throw InputError("Embree refuses the scene's triangles");
}

EmbreeTriangles::~EmbreeTriangles() = default;

std::size_t EmbreeTriangles::heap_bytes() const {
  return static_cast<std::size_t>(std::max<std::int64_t>(content_->bytes, 0)) +
         content_->primitives.capacity() * sizeof(std::uint32_t);
}

void EmbreeTriangles::search(const Ray<float>& ray, float limit, bool any, const Visitor& visitor) const {
  Context context;
  rtcInitIntersectContext(&context.embree);
  context.primitives = content_->primitives.data();
  context.data = visitor.data;
  context.visit = visitor.visit;
  constexpr float slack = 1e-5f;  // t comes from other arithmetic; the visitor knows the true range
  RTCRayHit query{};
  query.ray.org_x = ray.origin.x;
  query.ray.org_y = ray.origin.y;
  query.ray.org_z = ray.origin.z;
  query.ray.dir_x = ray.direction.x;
  query.ray.dir_y = ray.direction.y;
  query.ray.dir_z = ray.direction.z;
  query.ray.tnear = std::max(0.0f, ray.t_min - slack * std::abs(ray.t_min));
  query.ray.tfar = limit + slack * std::abs(limit);
  query.ray.mask = 0xffffffffu;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  if (any)
    rtcOccluded1(content_->scene, &context.embree, &query.ray);
  else
    rtcIntersect1(content_->scene, &context.embree, &query);
}

#else

namespace ps {

struct EmbreeTriangles::Content {};
EmbreeTriangles::EmbreeTriangles(const TracedGeometry<float>&) { throw InputError("Embree is not compiled in"); }
EmbreeTriangles::~EmbreeTriangles() = default;
std::size_t EmbreeTriangles::heap_bytes() const { return 0; }
void EmbreeTriangles::search(const Ray<float>&, float, bool, const Visitor&) const {}

#endif

std::shared_ptr<const EmbreeGeometry<float>> embree_geometry(const Scene& scene, const TracedGeometry<float>& geometry,
                                                             Prepared& prepared) {
  Key key("embree geometry");
  key.add(scene.geometry.revision());
  return prepared.get<EmbreeGeometry<float>>(key, [&] {
    EmbreeGeometry<float> result;
    std::vector<std::uint32_t> others;
    for (std::uint32_t k = 0; k < bounded_count(geometry); ++k) {
      const std::uint32_t i = bounded_primitive(geometry, k);
      if (geometry.primitives[i].kind != PrimitiveKind::triangle) others.push_back(i);
    }
    result.others = tree_over(geometry, others);
    if (!geometry.triangles.empty()) result.triangles = std::make_shared<const EmbreeTriangles>(geometry);
    return result;
  });
}

}  // namespace ps
