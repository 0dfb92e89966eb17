// Copies the depths of up to four samples of one pixel, for the inspector. It has the head of GLSL 3.30 only: ES 3.00 has no
// textures with several samples per pixel.
uniform sampler2DMS depth_samples;
uniform vec2 sampled_pixel;
uniform int first_sample, sample_count;

layout(location = 0) out vec4 sample_depths;

void main() {
  for (int i = 0; i < 4 && first_sample + i < sample_count; ++i)
    sample_depths[i] = texelFetch(depth_samples, ivec2(sampled_pixel), first_sample + i).x;
}
