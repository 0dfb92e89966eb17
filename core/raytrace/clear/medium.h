#pragma once

namespace ps {

/// What a ray runs through (CGFS ch. 5): the refraction index it carries along, and what lies around that material. The
/// chain lives on the stack of the recursion; that of eye rays begins in EyeMedia.
template <class Real>
struct Medium {
  Real index = 1;
  const Medium* around = nullptr;  ///< nullptr: the space outside of everything, index 1
};

/// Two rays follow where light splits. A branch that would bring less than this share to the pixel is not followed;
/// the other takes its share. This bounds the number of rays whatever the depth.
template <class Real>
inline constexpr Real least_branch_share = Real(1) / Real(4096);

}  // namespace ps
