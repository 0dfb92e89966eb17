#include "agreement/hardware/agreement_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "agreement/hardware/hardware_pair.h"
#include "base/number_text.h"
#include "hardware/gl_thread.h"
#include "options/renderer_kind.h"

namespace ps::test {
namespace {

constexpr std::string_view head = R"(# How the renderers agree

Made by `assets/gallery/make --agreement`, and checked by `tests/agreement/hardware/agreement_page_test.cpp`. The driver is
{}, with {} sub-pixel bits; the rasterizer has as many.
{}

A pixel differs if it shows another object or triangle, or if its colour differs by more than one level of 255. Its
difference belongs to the first of these causes whose repair makes it equal: the rasterizer draws the pixel again with
that one stage's values taken from the driver.

| cause | what the repair takes from the driver |
|---|---|
| coverage | which triangles cover the sample, or which lights' shadow volumes hold it |
| depth tie | which of two depths is nearer |
| clipping | the triangle before it was cut |
| interpolation | z, position, normal, texture coordinates, light of vertices |
| filtering | what was read from textures, shadow maps and environment maps |
| missing effect | nothing: the rasterizer leaves out what the driver does not honour |

Where no repair alone makes the pixel equal, the values of all stages up to a cause are taken together. At most 20 of
360,000 pixels may differ, unless a sentence below a row says why. Where coverage alone decides, the sample lies within a
sub-pixel step of an edge. `pixelscope-cli causes SCENE --stages` measures one row.

)";

constexpr std::string_view columns =
    "| scene and options | vertices rounded by | pixels | triangles | colours | by levels | coverage | depth tie | "
    "clipping | interpolation | filtering | missing effect | unexplained |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";

std::string line_of(const MeasuredMatrix::Row& row) {
  const StageSplit& split = row.split;
  std::string line =
      fmt::format("| {} | {} | {} | {} | {} | {} |", row.row.name(), row.snapping == "cpu" ? "processor" : "driver",
                  split.whole.pixels, split.whole.ids, split.whole.colours, split.largest);
  for (std::size_t i = 1; i < stage_cause_count; ++i) line += fmt::format(" {} |", split.shares[i].pixels);
  return line + "\n";
}

/// A sentence about a difference that this driver does not have would be none.
bool any_differ(const MeasuredMatrix& matrix, const MatrixRow& row) {
  return std::any_of(matrix.rows.begin(), matrix.rows.end(), [&](const MeasuredMatrix::Row& other) {
    return other.row.side == row.side && other.row.name() == row.name() && other.split.whole.pixels > 0;
  });
}

std::string ties_text(const TieCount& beyond) {
  std::string text = R"(
## Ties

A sample that lies exactly on an edge belongs to one of two triangles by the top-left rule, which the driver has, too. Of
triangles within the picture, with vertices on corners and centres of pixels, no sample differs.)";
  if (beyond.differ == 0)
    return text +
           fmt::format(" Where many triangles leave\nthe picture, none of {} samples differs either: this driver "
                       "has no need to cut them at the border.\n",
                       with_thousands(std::to_string(beyond.covered)));
  return text + fmt::format(R"( Where a triangle leaves
the picture, the driver cuts it at the border. The new vertices are rounded to sub-pixels, so the edges turn a little.
Samples that lay on them change sides: {} of {} where many triangles leave the picture. The rasterizer cuts one
pixel outside of the border.
)",
                            beyond.differ, with_thousands(std::to_string(beyond.covered)));
}

std::string table_of(const MeasuredMatrix& matrix, int side) {
  std::string table(columns), reasons;
  for (const MeasuredMatrix::Row& row : matrix.rows) {
    if (row.row.side != side) continue;
    table += line_of(row);
    if (!row.row.why.empty() && row.snapping == "cpu" && any_differ(matrix, row.row))
      reasons += fmt::format("- `{}`{}: {}\n", row.row.name(),
                             row.row.explained == Explained::for_driver ? ", rounded by the driver" : "", row.row.why);
  }
  return table + "\n" + reasons;
}

}  // namespace

StageSplit MeasuredMatrix::whole() const {
  StageSplit sum;
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < stage_cause_count; ++i) sum.shares[i].pixels += row.split.shares[i].pixels;
    sum.whole.pixels += row.split.whole.pixels;
  }
  return sum;
}

MeasuredMatrix measure_matrix(Renderer hardware) {
  MeasuredMatrix matrix;
  for (const auto& rows : {scene_rows(), option_rows()})
    for (const MatrixRow& row : rows)
      for (const char* snapping : {"cpu", "driver"})
        matrix.rows.push_back({row, snapping, measure(row, hardware, snapping)});
  for (const RayRow& row : ray_rows())
    matrix.rays.push_back({row, {against_rays(row, renderer_for(PictureWay::fragments)), against_rays(row, hardware)}});
  matrix.beyond_picture = count_ties(Reach::beyond_it, hardware);
  return matrix;
}

std::string agreement_page_name() { return drawn_by_llvmpipe() ? "agreement.md" : "agreement-gpu.md"; }

std::string agreement_page(const MeasuredMatrix& matrix) {
  const hardware::Driver& driver = *hardware::availability().driver;
  std::string page = fmt::format(fmt::runtime(head), driver.renderer, driver.subpixel_bits,
                                 drawn_by_llvmpipe() ? "[The same on a graphics card](agreement-gpu.md)."
                                                     : "[The same on the processor, by llvmpipe](agreement.md).");
  const StageSplit whole = matrix.whole();
  page += fmt::format("All rows together: {} pixels differ", whole.whole.pixels);
  for (std::size_t i = 1; i < stage_cause_count; ++i) {
    const auto cause = static_cast<StageCause>(i);
    page += fmt::format(", {:.1f} % {}", 100 * whole.part(cause), stage_cause_label(cause));
  }
  page += ".\n\n## Scenes, 600 x 600 pixels, hardware against rasterizer\n\nWithout shadows and reflections unless "
          "options ask for them.\n\n";
  page += table_of(matrix, 600);
  page += "\n## Options, 300 x 300 pixels, hardware against rasterizer\n\n" + table_of(matrix, 300);
  if (drawn_by_llvmpipe())
    page += "\n![lab/z-fighting with 24 depth bits: pixels that differ](agreement-z-fighting.png)\n"
            "![cgfs/fence filtered by the driver: pixels that differ](agreement-filter.png)\n"
            "\nIn the pictures vermilion is a depth tie and green is filtering.\n";
  page +=
      "\n## Triangles against rays, 300 x 300 pixels\n\nObjects or triangles, and colours by more than a level, that "
      "differ from the ray tracer's, and the RMS error in levels.\n\n"
      "| scene and options | rasterizer | | | hardware | | | why |\n|---|---|---|---|---|---|---|---|\n";
  for (const MeasuredMatrix::Ray& ray : matrix.rays) {
    page += fmt::format("| {} |", ray.row.name());
    for (const RayDifference& d : ray.drawn) page += fmt::format(" {} | {} | {:.2f} |", d.ids, d.colours, d.rms);
    page += fmt::format(" {} |\n", ray.row.why);
  }
  page += ties_text(matrix.beyond_picture);
  return page;
}

}  // namespace ps::test
