#include "options/rows.h"

namespace ps::rows {
namespace {

Reason needs_filling(const Settings& s, const SceneTraits&) {
  if (!fills(s.draw)) return needs("draw", Draw::filled);
  return {};
}

/// Filled row by row, a shape on the canvas has whole pixels for vertices, and all of its edge belongs to it. What lies
/// in space has edge functions all the same.
Reason needs_edges_of_fills(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_filling(s, t)) return reason;
  const bool in_space = t.triangles || t.spheres || t.solids;
  if (t.canvas_triangles && s.canvas_fill == CanvasFill::rows && !in_space)
    return needs("canvas-fill", CanvasFill::edges);
  return {};
}

Reason needs_single_samples(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_filling(s, t)) return reason;
  if (s.multisampling > 1) return needs("multisampling", 1).because("sub-samples are tested with edge functions");
  return {};
}

Reason needs_edge_functions(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_single_samples(s, t)) return reason;
  if (s.coverage != Coverage::edge_function) return needs("coverage", Coverage::edge_function);
  return {};
}

/// Lines cover whole pixels.
Reason needs_nothing_but_filling(const Settings& s, const SceneTraits&) {
  if (s.draw != Draw::filled) return needs("draw", Draw::filled);
  return {};
}

Reason needs_lines(const Settings& s, const SceneTraits& t) {
  if (s.draw != Draw::wireframe && s.draw != Draw::outlined && !t.canvas_items)
    return needs("draw", Draw::wireframe).said("needs draw = wireframe or a scene with lines");
  return {};
}

Reason needs_canvas_triangles(const Settings&, const SceneTraits& t) {
  if (!t.canvas_triangles) return "the scene has no triangle or polygon on the canvas";
  return {};
}

Reason needs_spheres(const Settings& s, const SceneTraits& t) {
  const bool patches = t.patches && s.patches == Patches::projected_error;
  if (!t.spheres && !t.solids && !patches) return "the scene has no curved surfaces";
  const bool maps = s.shadows == Shadows::map && s.lighting && t.casting_lights;
  if (sends_rays(s.renderer) && !maps)
    return IdleReason(IdleReason::Kind::renderer, "rays meet triangles of curved surfaces in shadow maps alone");
  return {};
}

Reason needs_patches(const Settings&, const SceneTraits& t) {
  if (!t.patches) return "the scene has no curved model such as the teapot";
  return {};
}

constexpr std::string_view common_coverage = "SIMD needs coverage = edge-function in 64-bit integers";
constexpr std::string_view own_coverage = "the driver has its own coverage test";

}  // namespace

std::vector<Option> drawing_rows() {
  return {
      choice<&Settings::draw>(
          {.key = "draw",
           .label = "Draw",
           .help =
               {"The part of each triangle that is drawn.", "CGFS ch. 6, 7 and 12",
                "Outlines over filled triangles ask for no depth: an edge stays where the next triangles leave it."},
           .keywords = "wireframe, lines, points, polygon mode, fill mode, outline, edges",
           .truth = other_picture(),
           .acts_for = ActsFor::fragments,
           .known_to = {.fast = {knows(fragment_batches, 10, Draw::filled).said("SIMD draws filled triangles only")},
                        .hardware = lacking("a driver draws filled triangles or their edges, not both in turn",
                                            Draw::outlined)},
           .shown_by = {.experiments = none, .scenes = {{"cgfs/crates"}}}},
          {{"filled", "filled", "All pixels that it covers."},
           {"wireframe", "wireframe", "Its three edges."},
           {"points", "points", "Its three vertices."},
           {"outlined", "filled, with outlines",
            "All pixels that it covers, then its three edges in 3/4 of its colour."}}),
      choice<&Settings::canvas_fill>(
          {.key = "canvas-fill",
           .label = "Fill of canvas shapes",
           .help = {"How triangles and convex polygons on the canvas are filled.", "LAB 4; CGFS ch. 7",
                    "By rows all edges count as inside, so neighbours overlap. A polygon of more than three vertices "
                    "has other colours inside, whichever is chosen, when it is turned."},
           .keywords = "polygon fill, scanline, row, span, Interpolate, ComputePolygonRows",
           .truth = exactly("canvas-fill=edge-functions"),
           .acts_for = ActsFor::fragments,
           .inactive = needs_canvas_triangles,
           .known_to = {.fast = any_value,
                        .hardware = lacking("the driver fills shapes by its own coverage test", CanvasFill::rows)},
           .shown_by = {.experiments = none, .scenes = {{"lab/polygons"}}}},
          {{"edge-functions", "edge functions",
            "Three edge functions for each sample, and the fill rule; polygons as triangles around their first "
            "vertex."},
           {"rows", "rows",
            "Row by row from the leftmost to the rightmost pixel of the edges, colours interpolated "
            "along the edges and then along the row."}}),
      choice<&Settings::line_algorithm>(
          {.key = "line-algorithm",
           .label = "Line algorithm",
           .help = {"The algorithm that chooses the pixels of a line.", "CGFS ch. 6; LAB 3",
                    "Stepping along x alone leaves gaps in steep lines; along y alone, in flat lines."},
           .keywords = "Bresenham, DDA, line drawing, gaps, staircase",
           .truth = exactly("line-algorithm=bresenham"),
           .acts_for = ActsFor::fragments,
           .inactive = needs_lines,
           .known_to = {.fast = any_value, .hardware = lacking("the driver has its own line algorithm")},
           .shown_by = {.experiments = {{"interpolate-drift"}}, .scenes = {{"cgfs/wireframe"}}}},
          {{"general", "general", "Steps along the axis in which the line is longer."},
           {"y-of-x", "y = f(x) alone", "One pixel for each column: steep lines have gaps."},
           {"x-of-y", "x = f(y) alone", "One pixel for each row: flat lines have gaps."},
           {"interpolate", "Interpolate", "Interpolates all values at once along the longer axis, as in the book."},
           {"bresenham", "Bresenham", "Integers only: an error term decides when to step in the other axis."}}),
      choice<&Settings::coverage>(
          {.key = "coverage",
           .label = "Coverage",
           .help = {"The algorithm that finds the samples inside a triangle. All exact algorithms give the same "
                    "picture and differ in the number of tests.",
                    "CGPP 15.6",
                    "The ray test tries every triangle at every pixel; barycentric weights in float may round to the "
                    "wrong side of an edge."},
           .keywords = "inside test, point in triangle, half-space, scan conversion, fill, rasterization",
           .truth = exactly("coverage=edge-function;edge-arithmetic=fixed"),
           .acts_for = ActsFor::fragments,
           .inactive = needs_single_samples,
           .known_to = {.fast = {knows(fragment_batches, 60, Coverage::edge_function).said(common_coverage)},
                        .hardware = lacking(own_coverage)},
           .shown_by = {.experiments = {{"coverage-growth"}, {"inclusive-scanlines"}},
                        .scenes = {{"lab/depth-complexity", "subpixel-bits=12"},
                                   {"cgfs/behind", "subpixel-bits=12;clipping=near"}}}},
          {{"edge-function", "edge functions",
            "Three edge functions for each sample of the bounding box, updated incrementally in integers."},
           {"ray-test", "ray test", "Intersects a ray through every pixel of the picture with every triangle."},
           {"bounding-box", "bounding box", "The same ray test, only for the samples in the triangle's bounding box."},
           {"barycentric", "barycentric weights",
            "Three quotients for each sample of the bounding box, in float or double."},
           {"hoisted", "barycentric, hoisted",
            "The same weights with two operations each: divisions once per triangle, sums once per row."},
           {"scanline", "scanline", "Fills each row from the left edge to the right edge without tests in between."},
           {"hierarchical", "hierarchical", "Rejects or accepts whole cells of 64, 16 and 4 pixels."},
           {"tiled", "tiled", "Tests tiles of 8 x 8 samples with 64-bit masks."},
           {"micropolygon", "micropolygons",
            "Splits the triangle into four, again and again, until the pieces are about as large as a pixel."}}),
      choice<&Settings::edge_arithmetic>(
          {.key = "edge-arithmetic",
           .label = "Edge arithmetic",
           .help = {"The arithmetic of the edge functions.", "CGPP 15.6.4.4",
                    "Float leaves cracks along shared edges. Stepped float drifts with every addition. 32-bit integers "
                    "overflow in triangles of more than about 128 pixels (at 8 sub-pixel bits)."},
           .keywords = "overflow, fixed point, integer, cracks, precision, half-space",
           .truth = exactly("edge-arithmetic=fixed"),
           .acts_for = ActsFor::fragments,
           .inactive = needs_edge_functions,
           .known_to = {.fast = {knows(fragment_batches, 60, EdgeArithmetic::fixed).said(common_coverage)},
                        .hardware = lacking(own_coverage)},
           .shown_by = {.experiments = {{"fill-rule-adversarial",
                                         [](const Settings& s) {
                                           return s.edge_arithmetic == EdgeArithmetic::float32 ||
                                                  s.edge_arithmetic == EdgeArithmetic::float_stepped;
                                         },
                                         "edge-arithmetic=fixed"},
                                        {"int32-edge-functions", is<&Settings::edge_arithmetic, EdgeArithmetic::int32>,
                                         "edge-arithmetic=fixed"},
                                        {"stepped-edge-drift"}},
                        .scenes = {{"cgfs/behind", "subpixel-bits=12;clipping=near"}}}},
          {{"fixed", "64-bit integers", "Exact for every triangle that fits."},
           {"float", "float",
            "Evaluates each sample anew; two triangles may round their shared edge to different sides."},
           {"float-stepped", "float, stepped", "One rounded addition per sample."},
           {"int32", "32-bit integers", "Exact until a product overflows."}}),
      integer<&Settings::multisampling>(
          {.key = "multisampling",
           .label = "Multisampling",
           .help = {"Tests coverage and depth at 2, 4 or 8 samples per pixel, but shades once per triangle. Other "
                    "values round down.",
                    "the standard sample patterns of Direct3D",
                    "Smooths the edges of triangles, not highlights or textures inside them."},
           .keywords = "AA, MSAA, antialias, antialiasing, anti-aliasing, jaggies, staircase, edges, coverage samples",
           .truth = pixel_average(),
           .acts_for = ActsFor::fragments,
           .inactive = needs_nothing_but_filling,
           .known_to = {.fast = {knows(fragment_batches, 50, 1)},
                        .hardware = as_driver_offers("the driver does not offer this number of samples per pixel")},
           .shown_by = {.experiments = none, .scenes = {{"cgfs/crates"}}}},
          1, 8, "samples"),
      integer<&Settings::subpixel_bits>(
          {.key = "subpixel-bits",
           .label = "Sub-pixel bits",
           .help = {"Vertices are rounded to 1 / 2^bits of a pixel before the edge functions are computed in exact "
                    "integers.",
                    "CGPP 15.6; Direct3D 11 uses 8", "With 0 bits, vertices jump to whole pixels and edges shift."},
           .keywords = "snapping, fixed point, vertex precision, wobble, jitter",
           .truth = exactly("subpixel-bits=12"),
           .acts_for = ActsFor::fragments,
           .inactive = needs_edges_of_fills,
           .known_to = {.fast = {limit(whole_tiles, 40, "whole tiles need at most 8 sub-pixel bits",
                                       [](const Settings& s, const SceneTraits&) {
                                         return s.subpixel_bits > fast_subpixel_bits;
                                       })},
                        .hardware = lacking("the driver has a fixed number of sub-pixel bits")},
           .shown_by = {.experiments = {{"sub-pixel-bits", [](const Settings& s) { return s.subpixel_bits < 8; },
                                         "subpixel-bits=8"},
                                        {"ray-vs-raster-agreement"}},
                        .scenes = {{"cgfs/crates"}}}},
          0, 12, "bits"),
      choice<&Settings::fill_rule>(
          {.key = "fill-rule",
           .label = "Fill rule",
           .help = {"Which triangle owns a sample that lies exactly on an edge.", "CGPP 15.6.4.4",
                    "Inclusive draws shared edges twice; exclusive leaves cracks."},
           .keywords = "top-left rule, shared edge, double hit, tie, cracks, overlap",
           .truth = exactly("fill-rule=top-left"),
           .acts_for = ActsFor::fragments,
           .inactive = needs_edges_of_fills,
           .known_to = {.fast = any_value, .hardware = lacking("the driver has the top-left rule")},
           .shown_by = {.experiments = {{"fill-rule-easy", is_not<&Settings::fill_rule, FillRule::top_left>,
                                         "fill-rule=top-left"},
                                        {"inclusive-scanlines"}},
                        .scenes = {{"lab/depth-complexity"}}}},
          {{"top-left", "top-left", "The triangle for which it is a top or left edge: each pixel is drawn once."},
           {"inclusive", "inclusive", "Both triangles, as in the book's scanlines."},
           {"exclusive", "exclusive", "Neither."}}),
      choice<&Settings::vertex_snapping>(
          {.key = "vertex-snapping",
           .label = "Vertex snapping",
           .help = {"Who rounds vertices to the sub-pixels of the graphics driver.", "OpenGL 3.3, 2.14 and 3.6.1",
                    "A driver rounds after its own arithmetic in float: a vertex near the middle between two "
                    "sub-pixels may move to the other one than in exact arithmetic."},
           .keywords = "sub-pixel precision, rounding, GL_SUBPIXEL_BITS, fixed point, driver, OpenGL, GPU",
           .truth = exactly("vertex-snapping=cpu"),
           .acts_for = ActsFor::readers,
           .only_for = "only the hardware renderer uses it",
           .inactive = needs_filling,
           .known_to = {.fast = any_value, .hardware = any_value},
           .shown_by = {.experiments = {{"driver-snapping"}}, .scenes = {{"cgfs/crates"}}}},
          {{"driver", "by the driver", "The driver projects vertices in float and rounds them."},
           {"cpu", "by the processor", "Vertices are projected in double and rounded before they are drawn."}}),
      real<&Settings::tessellation>(
          {.key = "tessellation",
           .label = "Tessellation error",
           .help = {"Maximum distance, in pixels, between a curved surface and its triangles.", "LAB 7; CGFS ch. 10",
                    "Too small: many triangles. Too large: polygonal outlines. Rays find them in shadow maps alone."},
           .keywords = "subdivision, level of detail, LOD, sphere triangles, silhouette, polygon count",
           .truth = pixel_average("tessellation=0.05"),
           .inactive = needs_spheres,
           .known_to = {.fast = any_value, .hardware = any_value},
           .shown_by = {.experiments = {{"silhouette-tessellation"}}, .scenes = {{"cgfs/reflections"}}}},
          0.05, 50, OptionScale::logarithmic, "px"),
      choice<&Settings::patches>(
          {.key = "patches",
           .label = "Curved models",
           .help = {"How finely a model of Bezier patches (the teapot) is tessellated.",
                    "LAB 7; CGFS ch. 10; bound of Filip, Magedson and Markot 1986",
                    "As made: polygonal outlines from near by, thousands of triangles in a few pixels from far away."},
           .keywords = "Bezier, Bézier, teapot, tessellation, level of detail, LOD, subdivision",
           .truth = pixel_average("patches=projected-error;tessellation=0.05"),
           .acts_for = ActsFor::fragments,
           .inactive = needs_patches,
           .known_to = {.fast = any_value, .hardware = any_value},
           .shown_by = {.experiments = none, .scenes = {{"cgpp/teapot", "tessellation=20"}}}},
          {{"as-made", "as made", "The number of triangles in the scene file, from every viewpoint."},
           {"projected-error", "by projected error",
            "The fewest triangles that keep within the tessellation error, for each instance from the current "
            "camera."}}),
  };
}

}  // namespace ps::rows
