// Normal mapping and parallax mapping, as in core/shade/normal_mapping.h and core/shade/parallax_mapping.h. A triangle's
// frame is the directions in which u grows and v falls.

#if STORY
vec4 story_stored = vec4(0.0);  // normal in tangent space; 1 where the map was used
vec3 story_tangent = vec3(0.0);
vec3 story_bitangent = vec3(0.0);
vec4 story_relief = vec4(0.0);  // shift from top to bottom in u and v; depth that was met; 1 where there is a relief
#endif

#if NORMAL_MAP
#if MAPPED_NORMALS == BY_INVERSE_TRANSPOSE
uniform mat3 placing;          // of the surface in the world
uniform mat3 placing_normals;  // its inverse transpose; both up to a factor
#endif

// A stored normal in the world; the surface's own where the map or the frame holds nothing usable.
vec3 mapped_normal(vec3 surface_normal, vec3 texel) {
#if MAPPED_NORMALS == BY_INVERSE_TRANSPOSE
  // The axes are made in the model. A vector before a matrix is multiplied by its transpose.
  vec3 normal = normalised(surface_normal * placing);
  vec3 u = along_u * placing_normals;
  vec3 up = upwards * placing_normals;
#else
  vec3 normal = normalised(surface_normal);
  vec3 u = along_u;
  vec3 up = upwards;
#endif
  vec3 across = u - normal * dot(normal, u);
  if (across == vec3(0.0)) return surface_normal;
  vec3 tangent = normalised(across);
  vec3 side = cross(normal, tangent);
  vec3 bitangent = dot(side, up) < 0.0 ? -side : side;
#if MAPPED_NORMALS == BY_INVERSE_TRANSPOSE
  float share = 1.0 / length_of(placing_normals * normal);
  tangent = placing_normals * tangent * share;
  bitangent = placing_normals * bitangent * share;
  normal = placing_normals * normal * share;
#endif
  vec3 stored = texel * 2.0 - 1.0;
#if STORY
  story_stored = vec4(stored, 1.0);
  story_tangent = tangent;
  story_bitangent = bitangent;
#endif
  vec3 turned = tangent * stored.x + bitangent * stored.y + normal * stored.z;
  return turned != vec3(0.0) ? unit_of(turned) : normal;
}
#endif

#if PARALLAX != PARALLAX_OFF
uniform sampler2D height_picture;
uniform ivec4 height_layout;
uniform int height_wrap;
uniform float relief_depth;  // of its bottom, in widths of the picture

// How far u and v run along the line of sight from the top of the relief to its bottom; false where the surface is seen
// edge-on or from behind.
bool relief_shift(vec3 normal, vec3 to_eye, out vec2 shift) {
  vec3 n = normalised(normal);
  vec3 v = normalised(to_eye);
  float cosine = dot(n, v);
  shift = vec2(0.0);
  if (!(cosine > 0.0)) return false;
  vec3 along = n * cosine - v;
#if PARALLAX != PARALLAX_LIMITED
  along /= cosine;
#endif
  float uu = dot(along_u, along_u);
  float uw = dot(along_u, upwards);
  float ww = dot(upwards, upwards);
  float area = uu * ww - uw * uw;
  if (!(area > 0.0)) return false;
  float scale = relief_depth * sqrt(uu) / area;
  float a = dot(along, along_u);
  float b = dot(along, upwards);
  shift = vec2((a * ww - b * uw) * scale, -((b * uu - a * uw) * scale));
  return true;
}

float depth_below(vec2 uv, Footprint footprint) {
  return 1.0 - read_texture(height_picture, height_layout, height_wrap, uv, footprint).colour.x;
}

// Where the line of sight meets the relief: texture coordinates.
vec2 relief_uv(vec2 uv, vec3 normal, vec3 to_eye, Footprint footprint) {
  vec2 shift;
  if (!relief_shift(normal, to_eye, shift)) return uv;
  float below = depth_below(uv, footprint);
#if STORY
  story_relief = vec4(shift, below, 1.0);
#endif
#if PARALLAX == PARALLAX_OFFSET || PARALLAX == PARALLAX_LIMITED
  return uv + shift * below;
#else
  float met = 0.0;
  float ray = 0.0;
  for (int i = 1; i <= PARALLAX_STEPS; ++i) {
    if (!(below > ray)) break;
    float before = below;
    float ray_before = ray;
    ray = float(i) / float(PARALLAX_STEPS);
    below = depth_below(uv + shift * ray, footprint);
    met = ray;
#if PARALLAX == PARALLAX_OCCLUSION
    if (!(below > ray)) {
      float gap_before = before - ray_before;
      float gap = ray - below;
      met = ray_before + (ray - ray_before) * (gap_before / (gap_before + gap));
    }
#endif
  }
#if STORY
  story_relief.z = met;
#endif
  return uv + shift * met;
#endif
}
#endif
