#pragma once
#include <array>
#include <cstddef>
#include <string_view>

namespace ps {

/// The intersection tests of a ray and a triangle. A new one is an enumerator and a row of texts here, its function in
/// a file of core/raytrace/clear, and its case in raytrace/triangle_tests.h.
enum class TriangleTest { watertight, moeller_trumbore, barycentric, cross_products };

/// What people read of it; see Choice (options/option.h).
struct TriangleTestTexts {
  TriangleTest test;
  std::string_view key, label, help;
  bool has_epsilon = true;  ///< option triangle-epsilon acts
};

/// In the order of the enum.
inline constexpr std::array triangle_test_texts{
    TriangleTestTexts{TriangleTest::watertight, "watertight", "watertight",
                      "Sheared edge functions: neighbours agree on every edge.", false},
    TriangleTestTexts{TriangleTest::moeller_trumbore, "moeller-trumbore", "Moeller-Trumbore",
                      "Cramer's rule on the barycentric equations."},
    TriangleTestTexts{TriangleTest::barycentric, "barycentric", "plane, then barycentrics",
                      "Intersects the plane, then solves for the barycentric weights."},
    TriangleTestTexts{TriangleTest::cross_products, "cross-products", "plane, then cross products",
                      "Intersects the plane, then tests on which side of each edge the point lies."}};

constexpr const TriangleTestTexts& texts_of(TriangleTest test) {
  return triangle_test_texts.at(static_cast<std::size_t>(test));
}

constexpr bool in_order_of_the_enum() {
  for (std::size_t i = 0; i < triangle_test_texts.size(); ++i)
    if (triangle_test_texts[i].test != static_cast<TriangleTest>(i)) return false;
  return true;
}
static_assert(in_order_of_the_enum());

}  // namespace ps
