// The children of a node: in which order they are visited, and what is fetched for them.
#if defined(PIXELSCOPE_WIDE_CHILDREN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELSCOPE_WIDE_CHILDREN_INL_H_
#undef PIXELSCOPE_WIDE_CHILDREN_INL_H_
#else
#define PIXELSCOPE_WIDE_CHILDREN_INL_H_
#endif

#include "accel/wide_bvh.h"
#include "hwy/cache_control.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace ps::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// An order of WideNode::order, a lane for each place.
using Slots = hn::CappedTag<std::uint32_t, wide_width>;
HWY_INLINE hn::Vec<Slots> slots_in_order(std::uint32_t order) {
  const Slots d;
  return hn::And(hn::Shr(hn::Set(d, order), hn::Mul(hn::Iota(d, 0), hn::Set(d, 3u))), hn::Set(d, 7u));
}

/// Asks the cache for what a waiting child leads to: a node, or the first block of a leaf.
template <class Block>
HWY_INLINE void fetch_soon(const WideNode* nodes, const Block* blocks, WideChild child) {
  const char* const begin = is_leaf(child) ? reinterpret_cast<const char*>(blocks + leaf_first(child))
                                           : reinterpret_cast<const char*>(nodes + child);
  const std::size_t bytes = is_leaf(child) ? sizeof(Block) : sizeof(WideNode);
  for (std::size_t line = 0; line < bytes; line += 64) hwy::Prefetch(begin + line);
}

}  // namespace ps::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
