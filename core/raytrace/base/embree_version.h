#pragma once
// What differs between Embree 3 and 4: how a query gets what it is asked with.
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace ps::embree {

#if RTC_VERSION_MAJOR >= 4
/// What a filter function gets back as `context`, where it may be the beginning of more.
using Query = RTCRayQueryContext;
inline void begin(Query& query) { rtcInitRayQueryContext(&query); }

inline void nearest(RTCScene scene, Query& query, RTCRayHit& ray) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &query;
  rtcIntersect1(scene, &ray, &arguments);
}
inline void any(RTCScene scene, Query& query, RTCRay& ray) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &query;
  rtcOccluded1(scene, &ray, &arguments);
}
/// For neighbouring rays.
inline void nearest_of_packet(RTCScene scene, const int* valid, RTCRayHit16& rays) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  rtcIntersect16(valid, scene, &rays, &arguments);
}
#else
using Query = RTCIntersectContext;
inline void begin(Query& query) { rtcInitIntersectContext(&query); }

inline void nearest(RTCScene scene, Query& query, RTCRayHit& ray) { rtcIntersect1(scene, &query, &ray); }
inline void any(RTCScene scene, Query& query, RTCRay& ray) { rtcOccluded1(scene, &query, &ray); }
inline void nearest_of_packet(RTCScene scene, const int* valid, RTCRayHit16& rays) {
  Query query;
  begin(query);
  query.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect16(valid, scene, &query, &rays);
}
#endif

}  // namespace ps::embree
