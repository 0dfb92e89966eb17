// Included once by each file that is compiled for fused multiply-adds, with its own flags.

namespace ps::stability {
namespace {

/// Whether this processor has the instructions that the file's flags allow.
bool has_instructions() {
#if defined(__x86_64__) && defined(__FMA__) && defined(__AVX2__)
  return __builtin_cpu_supports("fma") && __builtin_cpu_supports("avx2");
#elif defined(__x86_64__) && defined(__FMA__)
  return __builtin_cpu_supports("fma");
#elif defined(__aarch64__)
  return true;
#else
  return false;
#endif
}

}  // namespace
}  // namespace ps::stability
