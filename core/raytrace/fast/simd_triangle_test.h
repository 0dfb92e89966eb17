#pragma once

namespace ps {

/// The triangle tests of which there are SIMD kernels (fast/wide_triangles-inl.h, fast/wide_packet.cpp).
enum class SimdTriangleTest { watertight, moeller_trumbore };

}  // namespace ps
