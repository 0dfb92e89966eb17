#include "document/technique.h"

#include <deque>

#include <fmt/format.h>

#include "options/renderer_kind.h"

namespace ps {
namespace {

/// The same settings, whichever way the picture is made.
TechniqueSettings both_ways(const std::vector<std::string_view>& settings) { return {settings, settings}; }

TechniqueSettings by_rays(std::vector<std::string_view> settings) { return {std::move(settings), {}}; }

TechniqueSettings by_fragments(std::vector<std::string_view> settings) { return {{}, std::move(settings)}; }

/// "renderer=KEY"; the texts live as long as the table.
TechniqueSettings drawn_by(const RendererKind& kind) {
  static std::deque<std::string> texts;
  return both_ways({texts.emplace_back(fmt::format("renderer={}", kind.key))});
}

/// B is drawn by each renderer that this program has, A by the one that it is most like in purpose: rays and triangles
/// beside each other, triangles drawn here and by a graphics processor.
std::vector<TechniqueChoice> renderer_choices() {
  const RendererKind& rays = renderer_kind(renderer_for(PictureWay::rays));
  const RendererKind& triangles = renderer_kind(renderer_for(PictureWay::fragments));
  std::vector<TechniqueChoice> choices{{"rays", "Rays", drawn_by(triangles), drawn_by(rays)},
                                       {"triangles", "Triangles", drawn_by(rays), drawn_by(triangles)}};
  for (const RendererKind& kind : renderer_kinds())
    if (kind.added && kind.way == PictureWay::fragments)
      choices.push_back({"gpu", "GPU", drawn_by(triangles), drawn_by(kind)});
  return choices;
}

std::vector<Technique> table() {
  return {
      {.key = "shadows",
       .label = "Shadows",
       .with = "with shadows",
       .help = "Without them the distance of an object from the ground is not seen.",
       .keywords = "shadow, hard shadow, blocker",
       .choices = {{"off",
                    "without shadows",
                    {{"shadows=traced"}, {"shadows=stencil-depth-fail"}},
                    both_ways({"shadows=none"})}},
       .scenes = {"cgfs/shadows", "cgfs/reflections"}},
      {.key = "reflections",
       .label = "Reflections",
       .with = "with reflections",
       .help = "A ray that meets a mirror sends another ray.",
       .keywords = "mirror, reflection, recursion, bounce",
       .choices = {{"off", "without reflections", by_rays({"reflection-depth=3"}), by_rays({"reflection-depth=0"})}},
       .scenes = {"cgfs/reflections", "cgfs/mirrors"}},
      {.key = "highlights",
       .label = "Highlights",
       .with = "with highlights",
       .help = "The bright spot moves with the eye: it is the light's own reflection.",
       .keywords = "specular, shiny, gloss, phong highlight",
       .choices = {{"off", "without highlights", both_ways({"specular=on"}), both_ways({"specular=off"})}},
       .scenes = {"cgfs/reflections", "cgfs/lights"}},
      {.key = "anti-aliasing",
       .label = "Anti-aliasing",
       .with = "anti-aliased",
       .help = "Several samples for each pixel in place of one: edges lose their steps.",
       .keywords = "antialiasing, jaggies, staircase, samples, multisampling, supersampling",
       .choices = {{"off",
                    "one sample",
                    {{"samples-per-pixel=16"}, {"multisampling=8"}},
                    {{"samples-per-pixel=1"}, {"multisampling=1"}}}},
       .scenes = {"cgfs/fence", "cgfs/reflections"}},
      {.key = "shadow-epsilon",
       .label = "Shadow epsilon",
       .with = "epsilon 0.001",
       .help = "Without it a surface shadows itself: the shadow ray meets it again where it starts.",
       .keywords = "acne, shadow acne, self-shadowing, bias, epsilon",
       .choices = {{"off", "epsilon 0", by_rays({"self-hit=epsilon", "shadow-epsilon=0.001"}),
                    by_rays({"self-hit=epsilon", "shadow-epsilon=0"})}},
       .scenes = {"cgfs/shadows", "cgfs/reflections"}},
      {.key = "depth-buffer",
       .label = "Depth buffer",
       .with = "depth buffer",
       .help = "Without it the triangle that is drawn last is in front.",
       .keywords = "z-buffer, zbuffer, hidden surface, depth test, draw order",
       .choices = {{"off", "draw order", by_fragments({"visibility=depth-buffer"}),
                    by_fragments({"visibility=draw-order"})}},
       .scenes = {"cgfs/depth", "cgfs/cubes"}},
      {.key = "culling",
       .label = "Culling",
       .with = "with culling",
       .help = "Triangles whose back faces the camera are dropped: the picture stays, the work halves.",
       .keywords = "back-face culling, backface, cull face, winding",
       .choices = {{"off", "without culling", by_fragments({"backface-culling=on"}),
                    by_fragments({"backface-culling=off"})}},
       .scenes = {"cgfs/cubes", "cgfs/shading"}},
      {.key = "shading",
       .label = "Shading",
       .help = "Lit once for each triangle, at its vertices, or at each pixel.",
       .keywords = "flat, Gouraud, Phong, smooth shading, per-pixel lighting",
       .choices = {{"flat", "Flat", by_fragments({"shading=phong"}), by_fragments({"shading=flat"})},
                   {"gouraud", "Gouraud", by_fragments({"shading=phong"}), by_fragments({"shading=gouraud"})},
                   {"phong", "Phong", by_fragments({"shading=gouraud"}), by_fragments({"shading=phong"})}},
       .scenes = {"cgfs/shading", "cgfs/near-light"}},
      {.key = "texture-filter",
       .label = "Texture filter",
       .help = "One texel, the mean of four, or of a smaller copy of the texture where it is far away.",
       .keywords = "nearest, bilinear, mipmap, trilinear, sampling, moire, minification",
       .choices = {{"nearest",
                    "Nearest",
                    {{"texture-filter=bilinear"}, {"texture-filter=trilinear"}},
                    both_ways({"texture-filter=nearest"})},
                   {"bilinear",
                    "Bilinear",
                    {{"texture-filter=nearest"}, {"texture-filter=trilinear"}},
                    both_ways({"texture-filter=bilinear"})},
                   {"mipmap", "Mipmap", by_fragments({"texture-filter=bilinear"}),
                    by_fragments({"texture-filter=trilinear"})}},
       .scenes = {"cgfs/relief", "cgfs/crates"}},
      {.key = "perspective-correct",
       .label = "Perspective-correct",
       .with = "perspective-correct",
       .help = "Interpolated as if the triangle were flat on the screen, a texture bends at the diagonal.",
       .keywords = "perspective correct, affine, perspective correction, interpolation, texture warp",
       .choices = {{"off", "affine", by_fragments({"interpolation=perspective"}),
                    by_fragments({"interpolation=affine"})}},
       .scenes = {"cgfs/crates"}},
      {.key = "renderer",
       .label = "Renderer",
       .help = "Which surface does a pixel's ray meet first, or which pixels does a triangle cover?",
       .keywords = "ray tracer, rasterizer, hardware, OpenGL, rays or triangles",
       .choices = renderer_choices(),
       .scenes = {"cgfs/reflections"}},
  };
}

}  // namespace

std::span<const Technique> technique_table() {
  static const std::vector<Technique> all = table();
  return all;
}

const Technique* find_technique(std::string_view key) {
  for (const Technique& technique : technique_table())
    if (technique.key == key) return &technique;
  return nullptr;
}

}  // namespace ps
