#include "study/counted_work.h"

#include "render/fast_path.h"

namespace ps {

std::optional<std::uint64_t> counted_work(const Counters& counters) {
  return counted_sum(counters,
                     {Counter::eye_rays, Counter::shadow_rays, Counter::reflection_rays, Counter::refraction_rays,
                      Counter::sphere_tests, Counter::triangle_tests, Counter::solid_tests, Counter::node_visits,
                      Counter::coverage_tests, Counter::coverage_regions, Counter::stencil_tests, Counter::fragments,
                      Counter::texel_reads, Counter::shadow_map_taps, Counter::environment_reads});
}

std::string work_text(const std::optional<std::uint64_t>& work) { return work ? std::to_string(*work) : "none"; }

Settings counted_settings(const Settings& settings, const SceneTraits& traits) {
  Settings counted = settings;
  if (fast_path(settings, traits, Channel::none).machinery == Machinery::wide_triangles) counted.simd = Simd::off;
  return counted;
}

}  // namespace ps
