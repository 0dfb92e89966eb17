#include <tuple>

#include "options/simd_choice.h"
#include "raytrace/fast/wide_instances.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raytrace/fast/wide_instance_search.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
#include "hwy/highway.h"

#if HWY_ARCH_X86 && (HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3)
#include "raytrace/fast/wide_nodes-inl.h"
#include "raytrace/fast/wide_triangles-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ps::HWY_NAMESPACE {
namespace {

/// placed_corner() for the triangles of a block: the same operations in the same order.
HWY_INLINE void place_block(const ModelBlock& model, const WideInstance& instance, TriangleBlock& placed) {
  using D = hn::CappedTag<double, block_width>;
  const D d;
  const hn::Rebind<float, D> f;
  const auto& [scale, rotation, translation] =
      std::tie(instance.transform.scale, instance.transform.rotation, instance.transform.translation);
  for (int corner = 0; corner < 3; ++corner)
    for (std::size_t lane = 0; lane < block_width; lane += hn::Lanes(d)) {
      const auto& axes = model.corner[corner];
      const auto x = hn::Mul(hn::Set(d, scale.x), hn::Load(d, axes[0] + lane));
      const auto y = hn::Mul(hn::Set(d, scale.y), hn::Load(d, axes[1] + lane));
      const auto z = hn::Mul(hn::Set(d, scale.z), hn::Load(d, axes[2] + lane));
      for (int row = 0; row < 3; ++row) {
        const auto of_x = hn::Mul(hn::Set(d, rotation[0][row]), x), of_y = hn::Mul(hn::Set(d, rotation[1][row]), y),
                   of_z = hn::Mul(hn::Set(d, rotation[2][row]), z);
        const auto turned = hn::Add(hn::Add(of_x, of_y), of_z);
        hn::Store(hn::DemoteTo(f, hn::Add(turned, hn::Set(d, translation[row]))), f, placed.corner[corner][row] + lane);
      }
    }
  for (int lane = 0; lane < block_width; ++lane) placed.primitive[lane] = instance.first + model.triangle[lane];
}

/// Could the numbers of boxes overflow? See FastIntersector::suits_tree().
bool suits_model(const SlabRay<float>& ray, const IntoModel& into) {
  const Vec3f& i = ray.inverse;
  const float least = std::min({std::abs(i.x), std::abs(i.y), std::abs(i.z)});
  const double reach = std::max({into.reach.x, into.reach.y, into.reach.z});
  const double from = static_cast<double>(std::max(largest_component(ray.entering), largest_component(ray.leaving)));
  const double narrowest = std::min({into.spread.x, into.spread.y, into.spread.z});
  const double widest = std::max({into.spread.x, into.spread.y, into.spread.z});
  return least < 1e15f && std::max(reach, from) * static_cast<double>(least) < 1e15 && widest < 1e10 * narrowest;
}

enum class Find { nearest, any };

template <SimdTriangleTest test, Find find>
class Searcher {
 public:
  Searcher(const WideInstances& all, const WideQuery& query, const SingleTests& single, Hit<float>& best,
           WideCount& count)
      : all_(all), query_(query), single_(single), triangles_(query), best_(best), count_(count) {}

  void run() {
    const auto enter = [&](std::uint32_t first, std::uint32_t)
                           HWY_ATTR { return first != wide_empty_block && search_instance(all_.instances[first - 1]); };
    walk_nodes<find == Find::any>(all_.top.data(), all_.instances.data(), BoxRay(query_, all_.seen.centre), best_,
                                  count_.nodes, enter);
  }

 private:
  /// Whether `best` has improved.
  HWY_NOINLINE bool search_instance(const WideInstance& instance) {
    const auto slabs =
        slabs_in_model(instance.into, query_.ray.origin, query_.ray.direction, query_.pad, SlabForm::robust);
    if (!slabs || !suits_model(*slabs, instance.into)) return test_all(instance);
    bool improved = false;
    const WideModel& model = all_.models[instance.model];
    const auto test_blocks = [&](std::uint32_t first, std::uint32_t number) HWY_ATTR {
      bool found = false;
      for (std::uint32_t i = first; i < first + number; ++i) found |= test_block(instance, model.blocks[i]);
      improved |= found;
      return found;
    };
    walk_nodes<find == Find::any>(model.nodes.data(), model.blocks.data(), BoxRay(*slabs), best_, count_.nodes,
                                  test_blocks);
    return improved;
  }

  HWY_INLINE bool test_block(const WideInstance& instance, const ModelBlock& block) {
    bool found = false;
    if (HWY_UNLIKELY(instance.in_double)) {
      for (const std::uint32_t triangle : block.triangle)
        if (triangle != no_primitive) found |= single_.test(query_.ray, instance.first + triangle, best_);
      return found;
    }
    TriangleBlock placed;
    place_block(block, instance, placed);
    count_.triangles += block_width;
    for (int lane = 0; lane < block_width; lane += Block::lanes) found |= triangles_.test(placed, lane, query_, best_);
    return found;
  }

  bool test_all(const WideInstance& instance) {
    bool found = false;
    for (std::uint32_t i = 0; i < instance.count; ++i) {
      found |= single_.test(query_.ray, instance.first + i, best_);
      if (found && find == Find::any) break;
    }
    return found;
  }

  const WideInstances& all_;
  const WideQuery& query_;
  const SingleTests& single_;
  const BlockRay<test> triangles_;
  Hit<float>& best_;
  WideCount& count_;
};

template <SimdTriangleTest test, Find find>
void search(const WideInstances& all, const WideQuery& query, const SingleTests& single, Hit<float>& best,
            WideCount& count) {
  Searcher<test, find>(all, query, single, best, count).run();
}

template <SimdTriangleTest test>
constexpr InstanceSearches searches_with() {
  return {search<test, Find::nearest>, search<test, Find::any>};
}

}  // namespace

InstanceSearches instance_searches(SimdTriangleTest test) {
  switch (test) {
  case SimdTriangleTest::watertight:
    return searches_with<SimdTriangleTest::watertight>();
  case SimdTriangleTest::moeller_trumbore:
    return searches_with<SimdTriangleTest::moeller_trumbore>();
  }
  return {};
}

}  // namespace ps::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace ps {

InstanceSearches instance_searches(Simd simd, [[maybe_unused]] SimdTriangleTest test) {
  return PS_CHOSEN_KERNEL(InstanceSearches, simd, instance_searches(test));
}

}  // namespace ps
#endif
