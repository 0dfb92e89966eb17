#include "raster/fast/shade_batch.h"

#include <algorithm>

#include "options/simd_choice.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/fast/shade_batch_kernel.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
#include "hwy/highway.h"

#if HWY_ARCH_X86 && (HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3)
#include "raster/fast/shade_batch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ps::raster::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using shading::D;
using shading::V;
using shading::V3;

/// Fragments of one triangle: interpolate() of raster/base/fragment.h.
class OneTriangle {
 public:
  HWY_INLINE OneTriangle(const BatchShading& shading, const ShadeBatch& batch, int lane)
      : shading_(shading), z_(hn::LoadU(D(), batch.z.data() + lane)) {
    for (std::size_t i = 0; i < 3; ++i) weights_[i] = hn::LoadU(D(), batch.weights[i].data() + lane);
  }
  HWY_INLINE V z() const { return z_; }
  HWY_INLINE V3 vector(int slot) const { return {scalar(slot), scalar(slot + 1), scalar(slot + 2)}; }
  HWY_INLINE V3 pair(int slot) const { return {scalar(slot), scalar(slot + 1), hn::Zero(D())}; }
  HWY_INLINE V3 constant(int at) const { return shading::splat3({at_[at], at_[at + 1], at_[at + 2]}); }

 private:
  HWY_INLINE V scalar(int slot) const {
    const float* a = at_ + slot;
    const auto part = [&](std::size_t k) HWY_ATTR {
      return hn::Mul(weights_[k], shading::splat(a[static_cast<std::ptrdiff_t>(k) * shading_.stride]));
    };
    return hn::Mul(hn::Add(hn::Add(part(0), part(1)), part(2)), z_);
  }

  const BatchShading& shading_;
  const float* at_ = shading_.attributes;
  std::array<V, 3> weights_;
  V z_;
};

}  // namespace

void shade_fragments(const BatchShading& shading, ShadeBatch& batch);

void shade_fragments(const BatchShading& shading, ShadeBatch& batch) {
  const D d;
  const int lanes = static_cast<int>(hn::Lanes(d)), most = static_cast<int>(texture::Lookups::most);
  for (int first = 0; first < batch.count; first += most) {
    const int last = std::min(first + most, batch.count);
    texture::Lookups run;
    if (shading.texture.texture) {
      for (int lane = first; lane < last; lane += lanes) {
        const OneTriangle source(shading, batch, lane);
        shading::add_lookups(shading, source, source.z(), hn::FirstN(d, static_cast<std::size_t>(last - lane)), run);
      }
      texture::sample(shading.texture, run, batch.texels);
    }
    for (int lane = first; lane < last; lane += lanes) {
      const auto i = static_cast<std::size_t>((lane - first) / lanes);
      const V3 colour =
          shading::light_vector(shading, OneTriangle(shading, batch, lane), shading::own_colour(shading, run, i));
      hn::StoreU(colour.x, d, batch.red.data() + lane);
      hn::StoreU(colour.y, d, batch.green.data() + lane);
      hn::StoreU(colour.z, d, batch.blue.data() + lane);
    }
  }
}

}  // namespace ps::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace ps::raster {

ShadeFragments shade_function(Simd simd) { return PS_CHOSEN_KERNEL(ShadeFragments, simd, shade_fragments); }

}  // namespace ps::raster
#endif
