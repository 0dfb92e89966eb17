// What goes from the vertices to the fragments, and what both know of the view. Affine interpolation carries each value
// times w; the driver divides by w again, and the fragment multiplies by 1 / w.
#if PERSPECTIVE && AFFINE
#define CARRIED_SHARE(w) (w)
#else
#define CARRIED_SHARE(w) 1.0
#endif

struct Lighting {
  vec3 light;  // multiplies the colour of the surface
  vec3 extra;  // of materials with an ambient or specular colour of their own
};

uniform vec3 eye;       // world space
uniform vec3 backward;  // towards the viewer in orthographic pictures

#if ONE_LIGHT
uniform int light_number;  // that of this pass, or -1
uniform int first_light;   // that of the first pass, which adds what belongs to no light
#endif

// From a surface point towards the viewer.
vec3 direction_to_eye(vec3 position) {
#if PERSPECTIVE
  return eye - position;
#else
  return backward;
#endif
}

CARRIED vec3 carried_position;  // world space
CARRIED vec3 carried_normal;    // world space
CARRIED vec2 carried_uv;
CARRIED vec3 carried_weights;   // of the three vertices
CARRIED vec2 carried_z;         // camera space; and times w
CARRIED_FLAT vec3 face_normal;  // world space, length 1
#if EXACT_PLACES
CARRIED_FLAT vec3 plane_point;  // one vertex of the triangle, world space
#endif
CARRIED_FLAT int triangle_number;
#if RELIEF
CARRIED_FLAT vec3 along_u;      // world space; of both only the ratio of their lengths counts
CARRIED_FLAT vec3 upwards;
#endif
#if STORY
CARRIED vec3 story_screen;      // weights on the screen, times w
#endif
#if SHADING == GOURAUD
CARRIED vec3 carried_light;
CARRIED vec3 carried_extra;
#elif SHADING == FLAT
CARRIED_FLAT vec3 flat_light;
CARRIED_FLAT vec3 flat_extra;
#endif
