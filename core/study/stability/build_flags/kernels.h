#pragma once
#include <cstdint>

namespace ps::stability {

/// A ray and a triangle as nine and six floats.
struct FlagRay {
  float origin[3], direction[3];
};
struct FlagTriangle {
  float corner[3][3];
};

/// The same source, compiled several times with different flags for the compiler.
struct FlagBuild {
  const char* name;     ///< "-O2 -mfma"
  bool (*available)();  ///< does this processor have the instructions?
  bool (*watertight)(const FlagRay&, const FlagTriangle&);
  bool (*compared_products)(const FlagRay&, const FlagTriangle&);  ///< watertight, products compared, not subtracted
  bool (*kahan_products)(const FlagRay&, const FlagTriangle&);     ///< watertight, by Kahan's difference of products
  bool (*moeller_trumbore)(const FlagRay&, const FlagTriangle&);
  /// The book's reflection scene (CGFS ch. 4, depth 3, epsilon 0.001) in float: `side` x `side` pixels, 3 bytes each.
  void (*book_picture)(int side, std::uint8_t* pixels);
};

/// Plain: as the rest of the program is compiled.
FlagBuild plain_build();
FlagBuild contracted_build();  ///< fused multiply-add wherever the compiler can
FlagBuild fast_build();        ///< -ffast-math
FlagBuild fast_contracted_build();
FlagBuild unoptimised_build();
FlagBuild uncontracted_build();  ///< the instructions allowed, but nothing fused
FlagBuild x87_build();           ///< intermediate values with 64 bits of mantissa

}  // namespace ps::stability
