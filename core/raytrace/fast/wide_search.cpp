#include "raytrace/fast/wide_search.h"

#include <utility>

#include "options/simd_choice.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raytrace/fast/wide_search.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
#include "hwy/highway.h"

#if HWY_ARCH_X86 && (HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3)
#include "raytrace/fast/wide_nodes-inl.h"
#include "raytrace/fast/wide_triangles-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ps::HWY_NAMESPACE {
namespace {

enum class Find { nearest, any };

template <SimdTriangleTest test, Find find, Filtered filtered>
HWY_NOINLINE void search_tree(const WideBvh& bvh, const WideQuery& query, Hit<float>& best, WideCount& count) {
  const BlockRay<test> triangles(query);
  const TriangleBlock* const blocks = bvh.blocks.data();
  std::uint64_t block_tests = 0;
  const auto test_blocks = [&](std::uint32_t first, std::uint32_t number) HWY_ATTR {
    block_tests += number;
    bool found = false;
    for (std::uint32_t i = 0; i < number; ++i)
      for (int lane = 0; lane < block_width; lane += Block::lanes)
        found |= triangles.template test<filtered>(blocks[first + i], lane, query, best);
    return found;
  };
  walk_nodes<find == Find::any>(bvh.nodes.data(), blocks, BoxRay(query, bvh.centre), best, count.nodes, test_blocks);
  count.triangles += block_width * block_tests;
}

template <SimdTriangleTest test, Find find>
void search(const WideBvh& bvh, const WideQuery& query, Hit<float>& best, WideCount& count) {
  const auto chosen = query.filter ? search_tree<test, find, Filtered::yes> : search_tree<test, find, Filtered::no>;
  chosen(bvh, query, best, count);
}

/// Where nothing else turns triangles away, most blocks are passed.
template <SimdTriangleTest test>
HWY_INLINE bool test_listed(const BlockRay<test>& ray, const TriangleBlock& block, int lane, const WideQuery& query,
                            Hit<float>& best) {
  return !ray.passes_all(block, lane) && ray.test(block, lane, query, best);
}

template <SimdTriangleTest test, Find find>
void search_list(const TriangleList& list, const WideQuery& query, Hit<float>& best, WideCount& count) {
  const BlockRay<test> triangles(query);
  for (const TriangleBlock& block : list.blocks) {
    count.triangles += block_width;
    for (int lane = 0; lane < block_width; lane += Block::lanes)
      if (test_listed(triangles, block, lane, query, best) && find == Find::any) return;
  }
}

template <class BlockRays, std::size_t... index>
BlockRays block_rays(std::span<const WideQuery> queries, std::index_sequence<index...>) {
  return {typename BlockRays::value_type(queries[std::min(index, queries.size() - 1)])...};
}

template <SimdTriangleTest test>
void search_list_for_many(const TriangleList& list, std::span<const WideQuery> queries, std::span<Hit<float>> best,
                          WideCount& count) {
  using Ray = BlockRay<test>;
  const auto rays =
      block_rays<std::array<Ray, most_list_queries>>(queries, std::make_index_sequence<most_list_queries>());
  for (const TriangleBlock& block : list.blocks)
    for (std::size_t i = 0; i < queries.size(); ++i)
      for (int lane = 0; lane < block_width; lane += Block::lanes)
        test_listed(rays[i], block, lane, queries[i], best[i]);
  count.triangles += queries.size() * block_width * list.blocks.size();
}

template <SimdTriangleTest test>
constexpr WideSearches searches_with() {
  return {search<test, Find::nearest>, search<test, Find::any>, search_list<test, Find::nearest>,
          search_list<test, Find::any>, search_list_for_many<test>};
}

}  // namespace

WideSearches wide_searches(SimdTriangleTest test) {
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

WideSearches wide_searches(Simd simd, [[maybe_unused]] SimdTriangleTest test) {
  return PS_CHOSEN_KERNEL(WideSearches, simd, wide_searches(test));
}

}  // namespace ps
#endif
