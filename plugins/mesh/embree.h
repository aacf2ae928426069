// SPDX-License-Identifier: BSD-3-Clause
// The calls of Embree that differ between versions 3 and 4.
#pragma once

#if HOGELSCOPE_EMBREE >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace hogelscope::mesh {

#if HOGELSCOPE_EMBREE >= 4

using QueryContext = RTCRayQueryContext;

inline void intersect16(RTCScene scene, const int* valid, QueryContext& context,
                        RTCRayHit16& rays) {
  rtcInitRayQueryContext(&context);
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
  arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  rtcIntersect16(valid, scene, &rays, &arguments);
}
inline void intersect1(RTCScene scene, RTCRayHit& ray) {
  rtcIntersect1(scene, &ray, nullptr);
}
inline void occluded1(RTCScene scene, RTCRay& ray) {
  rtcOccluded1(scene, &ray, nullptr);
}

#else

using QueryContext = RTCIntersectContext;

inline void intersect16(RTCScene scene, const int* valid, QueryContext& context,
                        RTCRayHit16& rays) {
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect16(valid, scene, &context, &rays);
}
inline void intersect1(RTCScene scene, RTCRayHit& ray) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &ray);
}
inline void occluded1(RTCScene scene, RTCRay& ray) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene, &context, &ray);
}

#endif

}  // namespace hogelscope::mesh
