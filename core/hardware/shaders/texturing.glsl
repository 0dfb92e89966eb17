// Reading a texture texel by texel, with the formulas of core/image/texture_sampling.h and core/image/mip_level.h: the
// centre of texel (x, y) lies at ((x + 0.5) / width, (y + 0.5) / height), v = 0 is the top row.
//
// All levels of a texture lie side by side in one picture (core/hardware/level_atlas.h), since drivers may take one level
// for four neighbouring fragments, whatever texelFetch() asks for. A layout is (width, height, log2 of the height that
// level 1 and below share, number of the coarsest level).

uniform float mip_bias;

struct TextureRead {
  vec3 colour;
  float level;  // that was used
};

// How far u and v move from one pixel to the next, in texels of level 0.
struct Footprint {
  vec2 dx, dy;
};

#if STORY
// The level of detail that the derivatives ask for.
float asked_level(Footprint footprint) {
  return 0.5 * log2(max(dot(footprint.dx, footprint.dx), dot(footprint.dy, footprint.dy))) + mip_bias;
}
#endif

#if HARDWARE_TEXTURING

TextureRead read_texture(sampler2D picture, ivec4 layout_of, int wrap, vec2 uv, Footprint footprint) {
  return TextureRead(texture(picture, uv, mip_bias).rgb, -1.0);
}

#else

float wrap_coordinate(float u, int wrap) {
  float t = u;
  if (wrap == WRAP_REPEAT) {
    t = u - floor(u);
  } else if (wrap == WRAP_MIRROR) {
    float half_u = u * 0.5;
    t = (half_u - floor(half_u)) * 2.0;
    if (t > 1.0) t = 2.0 - t;
  }
  if (!(t > 0.0)) return 0.0;
  return t < 1.0 ? t : 1.0;
}

int wrap_texel(int x, int size, int wrap) {
  if (x < 0) return wrap == WRAP_REPEAT ? size - 1 : 0;
  if (x >= size) return wrap == WRAP_REPEAT ? 0 : size - 1;
  return x;
}

ivec2 level_size(ivec4 layout_of, int level) {
  return max(layout_of.xy >> level, 1);
}

// Where a level begins in the picture.
ivec2 level_place(ivec4 layout_of, int level) {
  if (level == 0) return ivec2(0);
  int shared_height = 1 << layout_of.z;
  return ivec2(layout_of.x, shared_height - (shared_height >> (level - 1)) + max(level - 2 - layout_of.z, 0));
}

vec3 sample_nearest(sampler2D picture, ivec4 layout_of, vec2 uv, int wrap) {
  vec2 at = vec2(wrap_coordinate(uv.x, wrap), wrap_coordinate(uv.y, wrap)) * vec2(layout_of.xy);
  return texelFetch(picture, min(ivec2(at), layout_of.xy - 1), 0).rgb;
}

vec3 sample_bilinear(sampler2D picture, ivec4 layout_of, vec2 uv, int wrap, int level) {
  ivec2 size = level_size(layout_of, level);
  ivec2 place = level_place(layout_of, level);
  vec2 p = vec2(wrap_coordinate(uv.x, wrap), wrap_coordinate(uv.y, wrap)) * vec2(size) - 0.5;
  vec2 whole = floor(p);
  vec2 f = p - whole;
  ivec2 first = ivec2(whole);
  ivec2 low = place + ivec2(wrap_texel(first.x, size.x, wrap), wrap_texel(first.y, size.y, wrap));
  ivec2 high = place + ivec2(wrap_texel(first.x + 1, size.x, wrap), wrap_texel(first.y + 1, size.y, wrap));
  vec3 left = texelFetch(picture, low, 0).rgb * (1.0 - f.y) + texelFetch(picture, ivec2(low.x, high.y), 0).rgb * f.y;
  vec3 right = texelFetch(picture, ivec2(high.x, low.y), 0).rgb * (1.0 - f.y) + texelFetch(picture, high, 0).rgb * f.y;
  return left * (1.0 - f.x) + right * f.x;
}

float level_log2(float value) {
  int bits = floatBitsToInt(value);
  int exponent = (bits - 0x3f3504f3) >> 23;
  float mantissa = intBitsToFloat(bits - (exponent << 23));
  float q = (mantissa - 1.0) / (mantissa + 1.0);
  float s = q * q;
  float sum = 1.0 / 7.0;
  sum = sum * s + 1.0 / 5.0;
  sum = sum * s + 1.0 / 3.0;
  sum = sum * s + 1.0;
  return float(exponent) + q * sum * 2.88539008177792681;
}

float clamp_level(float level, int coarsest) {
  if (!(level > 0.0)) return 0.0;
  return level < float(coarsest) ? level : float(coarsest);
}

TextureRead read_at_level(sampler2D picture, ivec4 layout_of, int wrap, vec2 uv, float level) {
#if TEXTURE_FILTER == FILTER_NEAREST
  return TextureRead(sample_nearest(picture, layout_of, uv, wrap), 0.0);
#elif TEXTURE_FILTER == FILTER_BILINEAR
  return TextureRead(sample_bilinear(picture, layout_of, uv, wrap, 0), 0.0);
#elif TEXTURE_FILTER == FILTER_MIPMAP
  int whole = int(clamp_level(level, layout_of.w) + 0.5);
  return TextureRead(sample_bilinear(picture, layout_of, uv, wrap, whole), float(whole));
#else
  float clamped = clamp_level(level, layout_of.w);
  int fine = int(clamped);
  float f = clamped - float(fine);
  vec3 near = sample_bilinear(picture, layout_of, uv, wrap, fine);
  if (!(f > 0.0)) return TextureRead(near, clamped);
  vec3 far = sample_bilinear(picture, layout_of, uv, wrap, fine + 1);
  return TextureRead(near * (1.0 - f) + far * f, clamped);
#endif
}

#if ANISOTROPY > 1

// Several lookups along the longer side of the footprint, at the level that suits its shorter one
// (core/image/anisotropic.h).
TextureRead read_texture(sampler2D picture, ivec4 layout_of, int wrap, vec2 uv, Footprint footprint) {
  bool across = dot(footprint.dx, footprint.dx) > dot(footprint.dy, footprint.dy);
  vec2 longer = across ? footprint.dx : footprint.dy;
  vec2 shorter = across ? footprint.dy : footprint.dx;
  float ratio = sqrt(dot(longer, longer) / dot(shorter, shorter));
  int taps = ratio < float(ANISOTROPY) ? int(ceil(ratio)) : ratio > 0.0 ? ANISOTROPY : 1;
  if (taps < 1) taps = 1;
  float share = float(taps);
  float level = 0.5 * level_log2(dot(longer, longer) / (share * share)) + mip_bias;
  vec2 along = longer / vec2(layout_of.xy);
  TextureRead sum = TextureRead(vec3(0.0), 0.0);
  for (int i = 0; i < taps; ++i) {
    float place = (float(i) + 0.5) / share - 0.5;
    TextureRead tap = read_at_level(picture, layout_of, wrap, uv + along * place, level);
    sum.colour += tap.colour;
    sum.level = tap.level;
  }
  sum.colour /= share;
  return sum;
}

#else

TextureRead read_texture(sampler2D picture, ivec4 layout_of, int wrap, vec2 uv, Footprint footprint) {
#if TEXTURE_FILTER == FILTER_NEAREST || TEXTURE_FILTER == FILTER_BILINEAR
  return read_at_level(picture, layout_of, wrap, uv, 0.0);
#else
  float longer = max(dot(footprint.dx, footprint.dx), dot(footprint.dy, footprint.dy));
  return read_at_level(picture, layout_of, wrap, uv, 0.5 * level_log2(longer) + mip_bias);
#endif
}

#endif
#endif
