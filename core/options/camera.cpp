#include "options/rows.h"

namespace ps::rows {

std::vector<Option> camera_rows() {
  return {
      choice<&Settings::sample_position>(
          {.key = "sample-position",
           .label = "Sample position",
           .help = {"Where inside a pixel its one sample lies.", "CGFS ch. 2; CGPP 15.4.1",
                    "The corner shifts the whole picture by half a pixel against programs that use centres."},
           .truth = pixel_average()},
          {{"centre", "centre", "The middle of the pixel, as most renderers do."},
           {"corner", "corner", "Its lower left corner: column 300 + x, row 299 - y on the book's 600 x 600 canvas."}}),
      choice<&Settings::projection>({.key = "projection",
                                     .label = "Projection",
                                     .help = {"How space becomes flat.", "CGFS ch. 9; LAB",
                                              "Orthographic pictures keep sizes but lose the sense of distance."},
                                     .truth = as_set()},
                                    {{"perspective", "perspective", "Distant things look smaller."},
                                     {"orthographic", "orthographic",
                                      "All rays are parallel; the viewport is the picture's size in the world."}}),
      choice<&Settings::viewport_fit>(
          {.key = "viewport-fit",
           .label = "Viewport fit",
           .help = {"Which side of the viewport is kept when the picture has another shape.", "CGFS ch. 2",
                    "Stretch turns circles into ellipses."},
           .truth = as_set()},
          {{"height", "keep height", "The width follows the picture."},
           {"width", "keep width", "The height follows the picture."},
           {"stretch", "stretch", "The viewport is kept as it is."}}),
      choice<&Settings::field_of_view_span>(
          {.key = "field-of-view-span",
           .label = "Field of view spans",
           .help = {"Whether the viewport reaches from edge to edge of the picture or from the first pixel's sample to "
                    "the last one's.",
                    "CGPP 15.4.1", "Mixing both up magnifies the picture by width / (width - 1)."},
           .truth = as_set()},
          {{"edges", "pixel edges", "The viewport's borders are the picture's borders."},
           {"centres", "pixel centres", "The viewport's borders run through the outermost samples."}}),
      toggle<&Settings::camera_relative>(
          {.key = "camera-relative",
           .label = "Relative to the camera",
           .help = {"Vertices lose the camera's position before they are rounded to float, not after.",
                    "the floating origin of large worlds; LAB 7",
                    "Off, vertices a million units from the origin jump between numbers 1/16 apart."},
           .truth = exactly("camera-relative=on"),
           .inactive = needs_fragments}),
      real<&Settings::near>(
          {.key = "near",
           .label = "Near limit",
           .help = {"Nothing nearer than this is seen. For rays it is the smallest t of an eye ray (t = 1 is the "
                    "viewport); for fragments, the distance of the near clipping plane in projection-plane distances.",
                    "CGFS ch. 2 and 11", "Too large cuts holes into near objects; too small wastes depth precision."},
           .truth = as_set()},
          1e-4, 1e4, OptionScale::logarithmic, "d"),
      real<&Settings::far>({.key = "far",
                            .label = "Far limit",
                            .help = {"Nothing farther than this is seen, measured like the near limit.", "CGFS ch. 2",
                                     "Too small cuts off the horizon."},
                            .truth = as_set()},
                           1e-3, 1e30, OptionScale::logarithmic, "d"),
  };
}

}  // namespace ps::rows
