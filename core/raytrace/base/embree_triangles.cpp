#include "raytrace/base/embree_triangles.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <mutex>

#include "base/check.h"
#include "base/stop.h"

#ifdef PIXELSCOPE_EMBREE
#include "raytrace/base/embree_version.h"

namespace ps {

struct EmbreeTriangles::Content {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<std::uint32_t> primitives;  ///< of Embree's triangles
  std::atomic<std::int64_t> bytes{0};

  /// Throws InputError if Embree cannot be started.
  void make(const TracedGeometry<float>& geometry);
  ~Content() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
};

namespace {

/// What a filter function gets to know of the query: Embree hands this back.
struct Context {
  embree::Query embree;
  const std::uint32_t* primitives;
  void* data;
  bool (*visit)(void* data, const EmbreeCandidate& candidate);
  float scale;  ///< of the query's direction
};

void filter(const RTCFilterFunctionNArguments* arguments) {
  const auto& context = *reinterpret_cast<const Context*>(arguments->context);
  for (unsigned i = 0; i < arguments->N; ++i) {
    if (arguments->valid[i] == 0) continue;
    const float u = RTCHitN_u(arguments->hit, arguments->N, i), v = RTCHitN_v(arguments->hit, arguments->N, i);
    const EmbreeCandidate candidate{context.primitives[RTCHitN_primID(arguments->hit, arguments->N, i)],
                                    RTCRayN_tfar(arguments->ray, arguments->N, i) * context.scale,
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

/// What Embree shares between its devices: allocators, and the tasks of a build. Its threads hand them on by atomic
/// operations within a library that ThreadSanitizer cannot look into. So one thread at a time makes a tree or lets one
/// go; searches need no turn.
struct EmbreeTriangles::Turns {
  std::mutex building;
  std::mutex leaving;  ///< guards `left`
  std::vector<std::unique_ptr<Content>> left;

  /// Frees what is left, unless another thread builds, which will do so afterwards.
  void free_left() {
    for (;;) {
      const std::unique_lock turn(building, std::try_to_lock);
      if (!turn) return;
      std::vector<std::unique_ptr<Content>> freed;
      {
        const std::lock_guard lock(leaving);
        freed.swap(left);
      }
      if (freed.empty()) return;
    }
  }

  /// Never destroyed: a tree may be let go while the program ends.
  static Turns& all() {
    static Turns& turns = *new Turns;
    return turns;
  }
};

void EmbreeTriangles::LetGo::operator()(Content* content) const {
  Turns& turns = Turns::all();
  {
    const std::lock_guard lock(turns.leaving);
    turns.left.emplace_back(content);
  }
  turns.free_left();  // waits for no build: the window's thread may be the one that lets go
}

void EmbreeTriangles::Content::make(const TracedGeometry<float>& geometry) {
  device = rtcNewDevice("threads=1");  // more would build another tree each time, and count other tests
  if (!device) throw InputError("Embree cannot be started");
  rtcSetDeviceMemoryMonitorFunction(device, count_bytes, &bytes);
  for (std::uint32_t i = 0; i < geometry.primitives.size(); ++i)
    if (is_float_triangle(geometry.primitives[i])) primitives.push_back(i);
  const std::size_t count = primitives.size();
  RTCGeometry triangles = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* positions = static_cast<Vec3f*>(
      rtcSetNewGeometryBuffer(triangles, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3f), 3 * count));
  auto* corners = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(triangles, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), count));
  if (positions != nullptr && corners != nullptr) {
    for (std::size_t i = 0; i < count; ++i) {
      const TracedTriangle<float>& triangle = geometry.triangles[geometry.primitives[primitives[i]].shape];
      positions[3 * i] = triangle.a;
      positions[3 * i + 1] = triangle.b;
      positions[3 * i + 2] = triangle.c;
      for (std::size_t k = 0; k < 3; ++k) corners[3 * i + k] = static_cast<std::uint32_t>(3 * i + k);
    }
    rtcSetGeometryIntersectFilterFunction(triangles, filter);
    rtcSetGeometryOccludedFilterFunction(triangles, filter);
    rtcCommitGeometry(triangles);
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcAttachGeometry(scene, triangles);
    const Progress* stop = current_stop();
    if (stop) rtcSetSceneProgressMonitorFunction(scene, goes_on, const_cast<Progress*>(stop));
    rtcCommitScene(scene);
    if (stop) rtcSetSceneProgressMonitorFunction(scene, nullptr, nullptr);
  }
  rtcReleaseGeometry(triangles);
}

EmbreeTriangles::EmbreeTriangles(const TracedGeometry<float>& geometry) : content_(new Content) {
  Turns& turns = Turns::all();
  {
    const std::lock_guard turn(turns.building);
    check_stop();
    content_->make(geometry);
  }
  turns.free_left();
  check_stop();
  if (rtcGetDeviceError(content_->device) != RTC_ERROR_NONE) throw InputError("Embree refuses the scene's triangles");
}

EmbreeTriangles::~EmbreeTriangles() = default;

std::size_t EmbreeTriangles::heap_bytes() const {
  return static_cast<std::size_t>(std::max<std::int64_t>(content_->bytes, 0)) +
         content_->primitives.capacity() * sizeof(std::uint32_t);
}

void EmbreeTriangles::search(const Ray<float>& ray, float limit, bool any, const Visitor& visitor) const {
  Context context;
  embree::begin(context.embree);
  context.primitives = content_->primitives.data();
  context.data = visitor.data;
  context.visit = visitor.visit;
  // Embree takes numbers up to 1.8e18, and directions whose components are above 1e-18.
  constexpr float largest = 1e18f, smallest = 0x1p-40f;
  if (!(largest_component(ray.origin) < largest)) return;
  const float length = largest_component(ray.direction);
  context.scale = length >= largest ? 0x1p-80f : length < smallest ? 0x1p80f : 1.0f;
  constexpr float slack = 1e-5f;  // t comes from other arithmetic; the visitor knows the true range
  RTCRayHit query{};
  query.ray.org_x = ray.origin.x;
  query.ray.org_y = ray.origin.y;
  query.ray.org_z = ray.origin.z;
  query.ray.dir_x = ray.direction.x * context.scale;
  query.ray.dir_y = ray.direction.y * context.scale;
  query.ray.dir_z = ray.direction.z * context.scale;
  query.ray.tnear = std::max(0.0f, ray.t_min - slack * std::abs(ray.t_min)) / context.scale;
  query.ray.tfar = (limit + slack * std::abs(limit)) / context.scale;
  if (!(query.ray.tnear <= query.ray.tfar)) return;
  query.ray.mask = 0xffffffffu;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  // Embree takes a component near 0 for 1e-18 where it tests boxes: a ray in the plane of a box's upper face leaves it
  // at t = 0. With the other sign it is in, but out of what lies above. So all signs are searched with.
  constexpr float nearly_zero = 1e-18f;
  struct Vanishing {
    float* component;
    float value;
  };
  std::array<Vanishing, 3> vanishing{};
  std::size_t count = 0;
  for (float* component : {&query.ray.dir_x, &query.ray.dir_y, &query.ray.dir_z})
    if (std::abs(*component) < nearly_zero) vanishing[count++] = {component, *component};
  for (std::size_t signs = 0; signs < std::size_t{1} << count; ++signs) {
    for (std::size_t k = 0; k < count; ++k)
      *vanishing[k].component = (signs >> k & 1) != 0 ? -nearly_zero : vanishing[k].value;
    if (any)
      embree::any(content_->scene, context.embree, query.ray);
    else
      embree::nearest(content_->scene, context.embree, query);
    if (query.ray.tfar < 0) return;  // Embree's word for a hit where any will do
  }
}

#else

namespace ps {

struct EmbreeTriangles::Content {};
void EmbreeTriangles::LetGo::operator()(Content* content) const { delete content; }
EmbreeTriangles::EmbreeTriangles(const TracedGeometry<float>&) { throw InputError("Embree is not compiled in"); }
EmbreeTriangles::~EmbreeTriangles() = default;
std::size_t EmbreeTriangles::heap_bytes() const { return 0; }
void EmbreeTriangles::search(const Ray<float>&, float, bool, const Visitor&) const {}

#endif

std::shared_ptr<const EmbreeGeometry<float>> embree_geometry(const Scene& scene, const TracedGeometry<float>& geometry,
                                                             Prepared& prepared) {
  Key key("embree geometry");
  key.add(scene.geometry.revision()).add(geometry.near_plane);
  return prepared.get<EmbreeGeometry<float>>(key, [&] {
    EmbreeGeometry<float> result;
    std::vector<std::uint32_t> others;
    for (std::uint32_t k = 0; k < bounded_count(geometry); ++k) {
      const std::uint32_t i = bounded_primitive(geometry, k);
      if (!is_float_triangle(geometry.primitives[i])) others.push_back(i);
    }
    result.others = tree_over(geometry, others);
    const auto& all = geometry.primitives;
    if (std::any_of(all.begin(), all.end(), is_float_triangle))
      result.triangles = std::make_shared<const EmbreeTriangles>(geometry);
    return result;
  });
}

}  // namespace ps
