#include "raytrace/fast/fast_intersector.h"

#include <algorithm>
#include <vector>

namespace ps {

Hit<float> FastIntersector::nearest(const Ray<float>& ray) const {
  const float reach = reach_of(ray);
  return suits(ray, reach) ? find<Find::nearest>(ray, reach) : clear_.nearest(ray);
}

Hit<float> FastIntersector::any(const Ray<float>& ray) const {
  const float reach = reach_of(ray);
  return suits(ray, reach) ? find<Find::any>(ray, reach) : clear_.any(ray);
}

void FastIntersector::nearest_of_each(std::span<const Ray<float>> rays, std::span<Hit<float>> hits) const {
  WidePacket packet{};  // not all lanes are in use everywhere
  packet.triangle_epsilon = inputs_.triangle_epsilon;
  packet.filter = filter_;
  const bool in_packets = wide_.wide && wide_.packets.make;
  const std::size_t together = in_packets ? wide_.packets.width : most_list_queries;
  for (std::size_t first = 0; first < rays.size(); first += together) {
    const std::size_t count = std::min(together, rays.size() - first);
    const auto some = rays.subspan(first, count);
    const auto found = hits.subspan(first, count);
    if (wide_.list && std::all_of(some.begin(), some.end(), is_searchable<float>))
      search_list_together(some, found);
    else if (in_packets && wide_.packets.make(some, wide_.seen, inputs_.box_padding, packet))
      search_tree_together(some, packet, found);
    else
      for (std::size_t i = 0; i < count; ++i) found[i] = nearest(some[i]);
  }
}

template <FastIntersector::Find what>
Hit<float> FastIntersector::find(const Ray<float>& ray, float reach) const {
  Hit<float> best;
  if (wide_.only_triangles)
    best.t = ray.t_max;
  else
    best = find_other(ray, what);
  if (what == Find::any && best.found()) return best;
  if (wide_.wide)
    search_tree(ray, reach, what, best);
  else if (wide_.list)
    search_list(ray, what, best);
  else
    search_instances(ray, reach, what, best);
  return best;
}

Hit<float> FastIntersector::find_other(const Ray<float>& ray, Find find) const {
  Hit<float> best;
  best.t = ray.t_max;
  const Query query{ray, dot(ray.direction, ray.direction)};
  const auto visit = [&](std::uint32_t primitive) { return clear_.test(query, primitive, best) && find == Find::any; };
  if (wide_.list) {
    for (const std::uint32_t primitive : wide_.list->others)
      if (visit(primitive)) return best;
    return best;
  }
  for (const std::uint32_t primitive : geometry_.unbounded)
    if (visit(primitive)) return best;
  const Bvh<float>& others = wide_.wide ? wide_.wide->others : wide_.instances->others;
  if (!others.nodes.empty()) for_each_candidate(others, clear_.candidate(ray), best.t, visit, recorder_);
  return best;
}

void FastIntersector::search_instances(const Ray<float>& ray, float reach, Find find, Hit<float>& best) const {
  const InstanceSearches& searches = wide_.instance_searches;
  const InstanceSearch search = find == Find::any ? searches.any : searches.nearest;
  WideCount work;
  search(*wide_.instances, {ray, inputs_.box_padding * reach, inputs_.triangle_epsilon, filter_}, clear_tests_, best,
         work);
  count(work);
}

void FastIntersector::search_list(const Ray<float>& ray, Find find, Hit<float>& best) const {
  const ListSearch search = find == Find::any ? wide_.searches.list_any : wide_.searches.list_nearest;
  WideCount work;
  search(wide_.list->triangles, {ray, 0, inputs_.triangle_epsilon, filter_}, best, work);
  count(work);
}

void FastIntersector::search_list_together(std::span<const Ray<float>> rays, std::span<Hit<float>> hits) const {
  std::vector<WideQuery> queries;
  queries.reserve(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    queries.push_back({rays[i], 0, inputs_.triangle_epsilon, filter_});
    hits[i] = find_other(rays[i], Find::nearest);
  }
  WideCount work;
  wide_.searches.list_nearest_of_many(wide_.list->triangles, queries, hits, work);
  count(work);
}

void FastIntersector::search_tree_together(std::span<const Ray<float>> rays, const WidePacket& packet,
                                           std::span<Hit<float>> hits) const {
  WidePacketHits best;
  best.t = packet.t_max;
  best.primitive.fill(static_cast<std::int32_t>(no_primitive));
  best.weights = {};
  if (!wide_.only_triangles) {
    nearest_others(rays, packet, hits);
    for (std::size_t lane = 0; lane < most_in_packet; ++lane) {
      const std::size_t i = std::min(lane, rays.size() - 1);
      best.t[lane] = hits[i].t;
      best.primitive[lane] = static_cast<std::int32_t>(hits[i].primitive);
    }
  }
  WideCount work;
  wide_.packets.nearest(wide_.wide->triangles, packet, best, work);
  count(work);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto primitive = static_cast<std::uint32_t>(best.primitive[i]);
    if (wide_.only_triangles || primitive != hits[i].primitive)
      hits[i] = {primitive, best.t[i], {best.weights[0][i], best.weights[1][i], best.weights[2][i]}, 0};
  }
}

void FastIntersector::nearest_others(std::span<const Ray<float>> rays, const WidePacket& packet,
                                     std::span<Hit<float>> hits) const {
  const Bvh<float>& others = wide_.wide->others;
  unsigned perhaps = others.nodes.empty() ? 0u : wide_.packets.meets(others.nodes[0].box, packet, wide_.seen.centre);
  if (!geometry_.unbounded.empty() || geometry_.some_in_double) perhaps = ~0u;  // the packet's pad is for float
  for (std::size_t i = 0; i < rays.size(); ++i) {
    hits[i] = {};
    hits[i].t = rays[i].t_max;
    if ((perhaps >> i & 1u) != 0) hits[i] = find_other(rays[i], Find::nearest);
  }
}

}  // namespace ps
