// The lanes of a packet of rays, and all its rays against boxes.
#if defined(PIXELSCOPE_PACKET_BOXES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELSCOPE_PACKET_BOXES_INL_H_
#undef PIXELSCOPE_PACKET_BOXES_INL_H_
#else
#define PIXELSCOPE_PACKET_BOXES_INL_H_
#endif

#include <cmath>

#include "hwy/highway.h"
#include "math/vec3-inl.h"
#include "raytrace/fast/wide_packet.h"

HWY_BEFORE_NAMESPACE();
namespace ps::HWY_NAMESPACE::packets {
namespace hn = hwy::HWY_NAMESPACE;
inline constexpr std::size_t width = HWY_TARGET == HWY_AVX3 ? 16 : 8;
using D = hn::CappedTag<float, width>;
using I = hn::RebindToSigned<D>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;
using P = Vec3Lanes<D>;

HWY_INLINE V all(float value) { return hn::Set(D(), value); }
template <class Tag>
HWY_INLINE unsigned bits_of(Tag d, hn::Mask<Tag> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  return bytes[0] | static_cast<unsigned>(bytes[1]) << 8;
}

/// One axis of the rays as boxes are tested; see BoxRay in wide_nodes-inl.h.
struct RayAxis {
  V inverse, near, far;
  std::size_t near_plane = 0, far_plane = 0;
};

HWY_INLINE RayAxis box_axis(const WidePacket& packet, const Vec3f& centre, std::size_t axis, V least) {
  const D d;
  const V direction = hn::Load(d, packet.direction[axis].data());
  const V origin = hn::Sub(hn::Load(d, packet.origin[axis].data()), all(centre[static_cast<int>(axis)]));
  const V sign = hn::And(direction, hn::SignBit(d));
  const V pad = hn::Or(all(1.25f * packet.pad), sign);
  RayAxis result;
  result.inverse = hn::Or(hn::Div(all(1), hn::Max(hn::Abs(direction), least)), sign);
  result.near = hn::Mul(hn::Add(origin, pad), result.inverse);
  result.far = hn::Mul(hn::Sub(origin, pad), result.inverse);
  const std::size_t down = std::signbit(packet.direction[axis][0]) ? 1 : 0;
  result.near_plane = 2 * axis + down;
  result.far_plane = 2 * axis + 1 - down;
  return result;
}

/// The rays of a packet as boxes are tested, seen from WideBvh::centre.
struct BoxAxes {
  HWY_INLINE BoxAxes(const WidePacket& packet, const Vec3f& centre) {
    const D d;
    const auto size = [&](std::size_t axis) { return hn::Abs(hn::Load(d, packet.direction[axis].data())); };
    const V least = hn::Mul(all(1e-20f), hn::Max(hn::Max(size(0), size(1)), size(2)));
    x = box_axis(packet, centre, 0, least);
    y = box_axis(packet, centre, 1, least);
    z = box_axis(packet, centre, 2, least);
  }
  RayAxis x, y, z;
};

/// Where the rays are inside a box, within [0, limit]; `plane(i)` is plane i of WideNode::planes.
struct LaneSpan {
  V first, last;
};
template <class Plane>
HWY_INLINE LaneSpan span_in_box(const BoxAxes& rays, V limit, Plane&& plane) {
  const auto& [x, y, z] = rays;
  const V in_x = hn::MulSub(plane(x.near_plane), x.inverse, x.near);
  const V in_y = hn::MulSub(plane(y.near_plane), y.inverse, y.near);
  const V in_z = hn::MulSub(plane(z.near_plane), z.inverse, z.near);
  const V out_x = hn::MulSub(plane(x.far_plane), x.inverse, x.far);
  const V out_y = hn::MulSub(plane(y.far_plane), y.inverse, y.far);
  const V out_z = hn::MulSub(plane(z.far_plane), z.inverse, z.far);
  return {hn::Max(in_z, hn::Max(in_y, hn::Max(in_x, hn::Zero(D())))),
          hn::Min(out_z, hn::Min(out_y, hn::Min(out_x, limit)))};
}

/// All rays of a packet from one point at once, against the eight boxes of a node: no ray enters a box before the
/// fastest one would, and none leaves it after the slowest. A plane behind the origin has a t below 0 for all of them,
/// whichever ray it is.
class Beam {
 public:
  using Boxes = hn::CappedTag<float, wide_width>;
  using B = hn::Vec<Boxes>;
  HWY_INLINE Beam(const WidePacket& packet, const Vec3f& centre, const BoxAxes& rays)
      : x_(side(packet, centre, 0, rays.x)), y_(side(packet, centre, 1, rays.y)), z_(side(packet, centre, 2, rays.z)) {}
  /// Bit i: some ray may meet box i before `limit`; planes as in WideNode::planes.
  HWY_INLINE unsigned meets(const float (&planes)[6][wide_width], float before) const {
    const Boxes d;
    const B limit = hn::Set(d, before);
    const B first = hn::Max(x_.entered(planes), hn::Max(y_.entered(planes), hn::Max(z_.entered(planes), hn::Zero(d))));
    const B last = hn::Min(x_.left(planes), hn::Min(y_.left(planes), hn::Min(z_.left(planes), limit)));
    return bits_of(d, hn::Le(first, hn::Mul(last, hn::Set(d, 1.00001f))));
  }

 private:
  struct Side {
    B fastest, slowest;  ///< 1 / direction, of the rays for which it is smallest and largest
    B near, far;         ///< the origin's parts, as in RayAxis
    std::size_t near_plane, far_plane;
    HWY_INLINE B entered(const float (&planes)[6][wide_width]) const {
      return hn::MulSub(hn::Load(Boxes(), planes[near_plane]), fastest, near);
    }
    HWY_INLINE B left(const float (&planes)[6][wide_width]) const {
      return hn::MulSub(hn::Load(Boxes(), planes[far_plane]), slowest, far);
    }
  };
  static HWY_INLINE Side side(const WidePacket& packet, const Vec3f& centre, std::size_t axis, const RayAxis& rays) {
    const D d;
    const float origin = packet.origin[axis][0] - centre[static_cast<int>(axis)];
    const float grown = std::copysign(1.25f * packet.pad, packet.direction[axis][0]);
    const V size = hn::Abs(rays.inverse);
    const float fastest = std::copysign(hn::GetLane(hn::MinOfLanes(d, size)), grown);
    const float slowest = std::copysign(hn::GetLane(hn::MaxOfLanes(d, size)), grown);
    const float near = (origin + grown) * fastest, far = (origin - grown) * slowest;
    const float rounding = 0x1p-21f;  // no box that a ray's own test enters may be turned away here
    const Boxes b;
    return {hn::Set(b, fastest),
            hn::Set(b, slowest),
            hn::Set(b, near + std::abs(near) * rounding),
            hn::Set(b, far - std::abs(far) * rounding),
            rays.near_plane,
            rays.far_plane};
  }
  Side x_, y_, z_;
};

}  // namespace ps::HWY_NAMESPACE::packets
HWY_AFTER_NAMESPACE();

#endif
