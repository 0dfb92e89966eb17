#include "options/rows.h"

namespace ps::rows {
namespace {

Reason needs_filling(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_fragments(s, t)) return reason;
  if (s.draw != Draw::filled) return "needs draw = filled";
  return {};
}

Reason needs_single_samples(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_filling(s, t)) return reason;
  if (s.multisampling > 1) return "needs multisampling = 1: sub-samples are tested with edge functions";
  return {};
}

Reason needs_edge_functions(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_single_samples(s, t)) return reason;
  if (s.coverage != Coverage::edge_function) return "needs coverage = edge-function";
  return {};
}

Reason needs_lines(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_fragments(s, t)) return reason;
  if (s.draw != Draw::wireframe && !t.canvas_items) return "needs draw = wireframe or a scene with lines";
  return {};
}

Reason needs_spheres(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_fragments(s, t)) return reason;
  const bool patches = t.patches && s.patches == Patches::projected_error;
  if (!t.spheres && !t.solids && !patches) return "the scene has nothing round";
  return {};
}

Reason needs_patches(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_fragments(s, t)) return reason;
  if (!t.patches) return "the scene has no curved model such as the teapot";
  return {};
}

}  // namespace

std::vector<Option> drawing_rows() {
  return {
      choice<&Settings::draw>({.key = "draw",
                               .label = "Draw",
                               .help = {"What is drawn of each triangle.", "CGFS ch. 6 and 7", ""},
                               .truth = exactly("draw=filled"),
                               .inactive = needs_fragments},
                              {{"filled", "filled", "All pixels that it covers."},
                               {"wireframe", "wireframe", "Its three edges."},
                               {"points", "points", "Its three corners."}}),
      choice<&Settings::line_algorithm>(
          {.key = "line-algorithm",
           .label = "Line algorithm",
           .help = {"How a line becomes pixels.", "CGFS ch. 6; LAB 3",
                    "Walking x alone leaves gaps in steep lines; walking y alone, in flat ones."},
           .truth = exactly("line-algorithm=bresenham"),
           .inactive = needs_lines},
          {{"general", "general", "Walks along the longer side."},
           {"y-of-x", "y = f(x) alone", "One pixel for each column: steep lines have gaps."},
           {"x-of-y", "x = f(y) alone", "One pixel for each row: flat lines have gaps."},
           {"interpolate", "Interpolate", "All steps from one interpolation over the longer side."},
           {"bresenham", "Bresenham", "Integers only: the error decides when to step sideways."}}),
      choice<&Settings::coverage>(
          {.key = "coverage",
           .label = "Coverage",
           .help =
               {"How the samples that a triangle covers are found. All exact ways give one picture; they differ in how "
                "many tests they need.",
                "CGPP 15.6",
                "The ray test asks every triangle for every pixel; barycentric weights in float may round to the "
                "wrong side of an edge."},
           .truth = exactly("coverage=edge-function;edge-arithmetic=fixed"),
           .inactive = needs_single_samples},
          {{"edge-function", "edge functions",
            "Three sums for each sample of the triangle's box, stepped in integers."},
           {"ray-test", "ray test", "A ray through every pixel of the picture against every triangle."},
           {"bounding-box", "bounding box", "The same ray test, for the samples of the triangle's box alone."},
           {"barycentric", "barycentric weights", "Three quotients for each sample of the box, in float or double."},
           {"hoisted", "barycentric, hoisted",
            "The same weights by two operations each: divisions are made once for a triangle, sums once for a row."},
           {"scanline", "scanline", "Row by row from the left edge to the right one; nothing to test in between."},
           {"hierarchical", "hierarchical", "Cells of 64, 16 and 4 pixels are dropped or taken whole."},
           {"tiled", "tiled", "Tiles of 8 x 8 samples, decided by 64-bit masks."},
           {"micropolygon", "micropolygons", "The triangle is cut in four until its pieces are about a pixel."}}),
      choice<&Settings::edge_arithmetic>(
          {.key = "edge-arithmetic",
           .label = "Edge arithmetic",
           .help =
               {"The numbers in which edge functions decide coverage.", "CGPP 15.6.4.4",
                "Float cracks along shared edges, stepped float drifts with every addition, 32-bit integers overflow "
                "in triangles of more than about 128 pixels (at 8 sub-pixel bits)."},
           .truth = exactly("edge-arithmetic=fixed"),
           .inactive = needs_edge_functions},
          {{"fixed", "64-bit integers", "Exact for every triangle that fits."},
           {"float", "float", "Each sample afresh; two triangles may round their edge to different sides."},
           {"float-stepped", "float, stepped", "One rounded addition for each sample."},
           {"int32", "32-bit integers", "Exact until a product overflows."}}),
      integer<&Settings::multisampling>(
          {.key = "multisampling",
           .label = "Multisampling",
           .help =
               {"Coverage and depth at 2, 4 or 8 places of each pixel, but one colour for each triangle in it. Values "
                "between act as the lower one.",
                "the standard sample patterns of Direct3D",
                "Smooths edges of triangles, not highlights or textures inside them."},
           .truth = pixel_average(),
           .inactive = needs_filling},
          1, 8, "samples"),
      integer<&Settings::subpixel_bits>(
          {.key = "subpixel-bits",
           .label = "Sub-pixel bits",
           .help = {"Corners are rounded to 1 / 2^bits of a pixel before the edges are computed in exact integers.",
                    "CGPP 15.6; Direct3D 11 uses 8", "With 0 bits corners jump to whole pixels and edges shift."},
           .truth = exactly("subpixel-bits=12"),
           .inactive = needs_filling},
          0, 12, "bits"),
      choice<&Settings::fill_rule>(
          {.key = "fill-rule",
           .label = "Fill rule",
           .help = {"Who owns a sample that lies exactly on an edge.", "CGPP 15.6.4.4",
                    "Inclusive draws shared edges twice, exclusive leaves cracks."},
           .truth = exactly("fill-rule=top-left"),
           .inactive = needs_filling},
          {{"top-left", "top-left", "The triangle for which the edge is a top or a left one: each pixel once."},
           {"inclusive", "inclusive", "Both triangles, as in the book's scanlines."},
           {"exclusive", "exclusive", "Neither."}}),
      real<&Settings::tessellation>(
          {.key = "tessellation",
           .label = "Tessellation error",
           .help = {"Spheres, cylinders and curved models are made of triangles that stray from them by at most this "
                    "much.",
                    "LAB 7; CGFS ch. 10", "Large values show corners on round outlines; small ones cost triangles."},
           .truth = exactly("tessellation=0.05"),
           .inactive = needs_spheres},
          0.05, 50, OptionScale::logarithmic, "px"),
      choice<&Settings::patches>(
          {.key = "patches",
           .label = "Curved models",
           .help = {"Into how many triangles a model of Bezier patches, the teapot, is cut.",
                    "LAB 7; CGFS ch. 10; bound of Filip, Magedson and Markot 1986",
                    "As made: corners on the outline near by, thousands of triangles in a few pixels far away."},
           .truth = exactly("patches=projected-error;tessellation=0.05"),
           .inactive = needs_patches},
          {{"as-made", "as made", "As many as the scene file says, from everywhere."},
           {"projected-error", "by projected error",
            "As few as stray by no more than the tessellation error, for each instance from where it is seen."}}),
  };
}

}  // namespace ps::rows
