// What a fragment reports of itself to the inspector: one page of four numbers for each draw. The picture's own outputs are
// plain variables meanwhile, and a fragment that would be discarded says so.
uniform int story_page;

layout(location = 0) out vec4 story_value;

bool story_cut_out = false;  // its opacity map is below 1/2
bool story_outside = false;  // it lies nearer or farther than the limits

#if DEFERRED && !SHADES_WHOLE_PICTURE
#define SHADES_HERE 0
#else
#define SHADES_HERE 1
#endif

// The pages that shading fills, with deferred shading in a pass of its own.
void report_shading(Lighting lighting, vec4 result) {
  switch (story_page) {
    case PAGE_LIGHT:
      story_value = vec4(lighting.light, 0.0);
      break;
    case PAGE_EXTRA:
      story_value = vec4(lighting.extra, 0.0);
      break;
    case PAGE_SHADED:
      story_value = result;
      break;
#if SHADING == PHONG && LIGHTS > 0 && SHADES_HERE
    case PAGE_TO_LIGHT:
      story_value = story_to_light;
      break;
    case PAGE_TERMS:
      story_value = story_terms;
      break;
#endif
#if (MIRRORS || REFLECTION_MAP) && SHADES_HERE
    case PAGE_MIRRORED:
      story_value = story_mirrored;
      break;
    case PAGE_MIRROR_PLACE:
      story_value = story_mirror_place;
      break;
    case PAGE_MIRROR_DIRECTION:
      story_value = vec4(story_mirror_direction, 0.0);
      break;
    case PAGE_UNMIRRORED:
      story_value = vec4(story_unmirrored, 0.0);
      break;
#endif
  }
}
