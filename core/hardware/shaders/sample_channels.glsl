// Copies what the first sample of each pixel shows. A blit may take any sample of integers, and mixes floats of different
// triangles. It has the head of GLSL 3.30 only: ES 3.00 has no textures with several samples per pixel.
uniform isampler2DMS seen_samples;
uniform sampler2DMS normal_samples, weight_samples;

layout(location = 1) out ivec4 seen;
layout(location = 2) out vec4 normal;
layout(location = 3) out vec4 weights;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  seen = texelFetch(seen_samples, pixel, 0);
  normal = texelFetch(normal_samples, pixel, 0);
  weights = texelFetch(weight_samples, pixel, 0);
}
