#pragma once
#include <algorithm>
#include <array>
#include <span>

#include "raytrace/clear/solid_line.h"

namespace ps {

/// A place where a line enters or leaves what the operations of a CSG tree make of its parts.
template <class Real>
struct Crossing {
  Real t = 0;
  std::uint32_t detail = 0;  ///< see solid_detail
  bool enters = false;
};

/// Which face of which part was met, and whether the part's normal is turned there, as on the faces that a subtracted
/// part leaves.
inline constexpr std::uint32_t solid_detail(std::size_t part, int face, bool turned) {
  return (static_cast<std::uint32_t>(part) << 4) | (static_cast<std::uint32_t>(face) << 1) | (turned ? 1u : 0u);
}
inline constexpr std::size_t detail_part(std::uint32_t detail) { return detail >> 4; }
inline constexpr int detail_face(std::uint32_t detail) { return static_cast<int>((detail >> 1) & 7u); }
inline constexpr bool detail_turned(std::uint32_t detail) { return (detail & 1u) != 0; }

template <class Real>
struct Crossings {
  std::array<Crossing<Real>, 2 * max_csg_parts> list{};
  std::size_t count = 0;
};

/// Is a point inside the whole, given in which parts it is (one bit each)?
inline bool csg_inside(std::span<const CsgStep> steps, std::uint32_t inside) {
  std::uint64_t stack = 0;  // one bit each, the top lowest
  for (const CsgStep& step : steps) {
    const bool top = (stack & 1u) != 0, below = (stack & 2u) != 0;
    switch (step.kind) {
    case CsgStep::Kind::part:
      stack = (stack << 1) | ((inside >> step.part) & 1u);
      break;
    case CsgStep::Kind::union_of:
      stack = ((stack >> 2) << 1) | static_cast<std::uint64_t>(below || top);
      break;
    case CsgStep::Kind::intersection:
      stack = ((stack >> 2) << 1) | static_cast<std::uint64_t>(below && top);
      break;
    case CsgStep::Kind::difference:
      stack = ((stack >> 2) << 1) | static_cast<std::uint64_t>(below && !top);
      break;
    }
  }
  return (stack & 1u) != 0;
}

/// The crossings of a line with a CSG tree in order of t (CGFS ch. 5): walks along the ends of all parts' spans, keeps
/// in which parts it is, and notes where the answer of the whole changes. Ends at the same t count as one place, so
/// faces that coincide leave no skin between them. `span_of(part)` gives the line's span in a part.
template <class Real, class SpanOf>
Crossings<Real> csg_crossings(std::size_t parts, std::span<const CsgStep> steps, SpanOf&& span_of) {
  struct End {
    Real t;
    std::uint32_t part;
    int face;
    bool enters;
  };
  std::array<End, 2 * max_csg_parts> ends;
  std::size_t count = 0;
  for (std::size_t part = 0; part < parts; ++part) {
    const LineSpan<Real> span = span_of(part);
    if (span.empty) continue;
    const auto index = static_cast<std::uint32_t>(part);
    ends[count++] = {span.enter, index, span.enter_face, true};
    ends[count++] = {span.leave, index, span.leave_face, false};
  }
  std::sort(ends.begin(), ends.begin() + static_cast<std::ptrdiff_t>(count), [](const End& a, const End& b) {
    return a.t < b.t || (a.t == b.t && (a.part < b.part || (a.part == b.part && a.enters && !b.enters)));
  });
  Crossings<Real> crossings;
  std::uint32_t inside = 0;
  bool whole = false;
  for (std::size_t i = 0; i < count;) {
    const Real t = ends[i].t;
    std::size_t cause = i;  // the end after which the answer changed for good
    bool before = whole;
    for (; i < count && ends[i].t == t; ++i) {
      inside = ends[i].enters ? inside | (1u << ends[i].part) : inside & ~(1u << ends[i].part);
      const bool now = csg_inside(steps, inside);
      if (now != before) cause = i;
      before = now;
    }
    if (before == whole) continue;
    whole = before;
    const End& end = ends[cause];
    crossings.list[crossings.count++] = {t, solid_detail(end.part, end.face, end.enters != whole), whole};
  }
  return crossings;
}

}  // namespace ps
