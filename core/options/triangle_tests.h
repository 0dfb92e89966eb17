#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace ps {

/// The intersection tests of a ray and a triangle. A new one is an enumerator and a row here, its function in
/// a file of core/raytrace/clear, and its case in raytrace/clear/triangle_query.h.
enum class TriangleTest { watertight, moeller_trumbore, barycentric, cross_products };

/// The tests of which there are SIMD kernels (raytrace/fast/wide_triangles-inl.h, raytrace/fast/wide_packet.cpp).
enum class SimdTriangleTest { watertight, moeller_trumbore };

/// Its texts for people, see Choice (options/option.h), and the facts that renderers ask for.
struct TriangleTestRow {
  TriangleTest test;
  std::string_view key, label, help;
  std::optional<SimdTriangleTest> simd;  ///< the kernels that repeat it; without them the clear path searches
  bool has_epsilon = true;               ///< option triangle-epsilon acts
};

/// In the order of the enum.
inline constexpr std::array triangle_test_rows{
    TriangleTestRow{TriangleTest::watertight, "watertight", "watertight",
                    "Sheared edge functions: neighbours agree on every edge.", SimdTriangleTest::watertight, false},
    TriangleTestRow{TriangleTest::moeller_trumbore, "moeller-trumbore", "Moeller-Trumbore",
                    "Cramer's rule on the barycentric equations.", SimdTriangleTest::moeller_trumbore},
    TriangleTestRow{TriangleTest::barycentric, "barycentric", "plane, then barycentrics",
                    "Intersects the plane, then solves for the barycentric weights.", std::nullopt},
    TriangleTestRow{TriangleTest::cross_products, "cross-products", "plane, then cross products",
                    "Intersects the plane, then tests on which side of each edge the point lies.", std::nullopt}};

constexpr const TriangleTestRow& row_of(TriangleTest test) {
  return triangle_test_rows.at(static_cast<std::size_t>(test));
}

constexpr bool in_order_of_the_enum() {
  for (std::size_t i = 0; i < triangle_test_rows.size(); ++i)
    if (triangle_test_rows[i].test != static_cast<TriangleTest>(i)) return false;
  return true;
}
static_assert(in_order_of_the_enum());

}  // namespace ps
