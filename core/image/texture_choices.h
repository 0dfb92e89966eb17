#pragma once

namespace ps {

/// How a texture is read between its texels (CGFS ch. 14).
enum class TextureFilter { trilinear, mipmap, bilinear, nearest };
/// The texels beyond its edges.
enum class TextureWrap { repeat, clamp, mirror };

}  // namespace ps
