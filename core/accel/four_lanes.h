#pragma once
#include <cstdint>

namespace ps {

/// x, y, z and one more number that the processor handles together with them (GCC and clang vectors; a processor
/// without the registers works through them one by one).
template <class Real>
struct FourLanes;
template <>
struct FourLanes<float> {
  typedef float Type __attribute__((vector_size(16)));
  typedef std::int32_t Index __attribute__((vector_size(16)));
};
template <>
struct FourLanes<double> {
  typedef double Type __attribute__((vector_size(32)));
  typedef std::int64_t Index __attribute__((vector_size(32)));
};
template <class Real>
using Lanes4 = typename FourLanes<Real>::Type;

}  // namespace ps
