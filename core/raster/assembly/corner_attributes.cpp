#include "raster/assembly/corner_attributes.h"

#include "math/unit.h"
#include "raster/base/light_at.h"
#include "shade/normal_mapping.h"

namespace ps::raster {
namespace {

template <class Real>
void put(CornerAttributes<Real>& corner, int slot, const Vec3<Real>& value) {
  if (slot == AttributeLayout::absent) return;
  const auto first = static_cast<std::size_t>(slot);
  for (std::size_t i = 0; i < 3; ++i) corner[first + i] = value[static_cast<int>(i)];
}

template <class Real>
std::optional<TangentFrame<Real>> frame_of(const CornerSource<Real>& source) {
  std::array<Vec3<Real>, 3> positions;
  std::array<Vec2<Real>, 3> uvs;
  for (std::size_t k = 0; k < 3; ++k) {
    if (source.triangle->uv[k] < 0) return {};
    positions[k] = source.position(k);
    uvs[k] = Vec2<Real>(source.mesh->uvs[static_cast<std::size_t>(source.triangle->uv[k])]);
  }
  return triangle_frame<Real>(positions, uvs);
}

}  // namespace

template <class Real>
std::array<CornerAttributes<Real>, 3> corner_attributes(const RasterInputs<Real>& inputs, const Surface<Real>& surface,
                                                        const CornerSource<Real>& source, CountingRecorder& recorder) {
  const AttributeLayout& layout = surface.layout;
  const Normals normals = inputs.settings.normals;
  std::array<CornerAttributes<Real>, 3> corners;
  TangentFrame<Real> tangents;  // zeros: the normal stays as it is
  if (layout.tangents != AttributeLayout::absent) tangents = frame_of(source).value_or(tangents);
  for (std::size_t k = 0; k < 3; ++k) {
    if (layout.normal != AttributeLayout::absent) put(corners[k], layout.normal, source.normal(k, normals));
    if (layout.position != AttributeLayout::absent) put(corners[k], layout.position, source.position(k));
    const auto uv = source.triangle->uv[k];
    if (layout.uv != AttributeLayout::absent) {
      const Vec2d value = uv >= 0 ? source.mesh->uvs[static_cast<std::size_t>(uv)] : Vec2d(0);
      corners[k][static_cast<std::size_t>(layout.uv)] = static_cast<Real>(value.x);
      corners[k][static_cast<std::size_t>(layout.uv) + 1] = static_cast<Real>(value.y);
    }
    if (layout.tangents != AttributeLayout::absent) {
      put(corners[k], layout.tangents, tangents.along_u);
      put(corners[k], layout.tangents + 3, tangents.upwards);
    }
    if (layout.light != AttributeLayout::absent) {
      const Lighting<Real> lighting =
          light_at(inputs, surface, source.position(k), source.normal(k, normals), recorder);
      put(corners[k], layout.light, lighting.light);
      put(corners[k], layout.extra, lighting.extra);
    }
  }
  return corners;
}

template <class Real>
FlatPoint<Real> flat_point(const CornerSource<Real>& source, Normals normals) {
  const auto mean = [](const Vec3<Real>& a, const Vec3<Real>& b, const Vec3<Real>& c) { return (a + b + c) / Real(3); };
  FlatPoint<Real> point;
  point.position = mean(source.position(0), source.position(1), source.position(2));
  point.normal = mean(source.normal(0, normals), source.normal(1, normals), source.normal(2, normals));
  point.normal = unit_or_zero(point.normal);
  return point;
}

#define PS_INSTANTIATE(Real)                                                                                           \
  template std::array<CornerAttributes<Real>, 3> corner_attributes(const RasterInputs<Real>&, const Surface<Real>&,    \
                                                                   const CornerSource<Real>&, CountingRecorder&);      \
  template FlatPoint<Real> flat_point(const CornerSource<Real>&, Normals);
PS_INSTANTIATE(float)
PS_INSTANTIATE(double)
#undef PS_INSTANTIATE

}  // namespace ps::raster
