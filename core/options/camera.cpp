#include "options/rows.h"

namespace ps::rows {

std::vector<Option> camera_rows() {
  Option far = real<&Settings::far>({.key = "far",
                                     .label = "Far limit",
                                     .help = {"Surfaces farther than this are not seen; measured as the near limit is.",
                                              "CGFS ch. 2", "Too small: cuts off the horizon."},
                                     .keywords = "far plane, clip plane, frustum, t max, z far, draw distance",
                                     .truth = as_set(),
                                     .known_to = {.fast = any_value, .hardware = any_value},
                                     .shown_by = {.experiments = none, .scenes = {{"cgfs/reflections"}}}},
                                    1e-3, no_far_limit, OptionScale::logarithmic, "d");
  far.sweep_values = "10,100,1000,10000";  // evenly spread over the range, most values would not clip
  return {
      choice<&Settings::sample_position>(
          {.key = "sample-position",
           .label = "Sample position",
           .help = {"Position of the sample inside its pixel.", "CGFS ch. 2; CGPP 15.4.1",
                    "The pixel corner shifts the whole picture by half a pixel against programs that use centres."},
           .keywords = "pixel centre, pixel center, half-pixel offset, pixel grid",
           .truth = pixel_average(),
           .known_to = {.fast = any_value, .hardware = any_value},
           .shown_by = {.experiments = none, .scenes = {{"cgfs/reflections"}}}},
          {{"centre", "centre", "The centre of the pixel, as in most renderers."},
           {"corner", "corner", "Its lower left corner: column 300 + x, row 299 - y on the book's 600 x 600 canvas."}}),
      choice<&Settings::projection>(
          {.key = "projection",
           .label = "Projection",
           .help = {"How 3D points are projected onto the image.", "CGFS ch. 9; LAB",
                    "Orthographic projection keeps sizes but shows no distance."},
           .keywords = "perspective, orthographic, parallel projection, camera, matrix",
           .truth = other_picture(),
           .known_to = {.fast = {knows(fragment_batches, 20, Projection::perspective),
                                 knows(sphere_packets, 40, Projection::perspective)},
                        .hardware = any_value},
           .shown_by = {.experiments = none, .scenes = {{"cgfs/reflections"}}}},
          {{"perspective", "perspective", "Distant objects look smaller."},
           {"orthographic", "orthographic",
            "All rays are parallel; the viewport has the size of the visible part of the world."}}),
      choice<&Settings::viewport_fit>(
          {.key = "viewport-fit",
           .label = "Viewport fit",
           .help = {"The dimension of the viewport that is kept when the picture has another aspect ratio.",
                    "CGFS ch. 2", "Stretch turns circles into ellipses."},
           .keywords = "aspect ratio, fov, field of view, stretch, resize",
           .truth = other_picture(),
           .known_to = {.fast = any_value, .hardware = any_value},
           .shown_by = {.experiments = none, .scenes = {{"cgfs/reflections"}}}},
          {{"height", "keep height", "The width follows the picture."},
           {"width", "keep width", "The height follows the picture."},
           {"stretch", "stretch", "Width and height of the viewport are kept."}}),
      choice<&Settings::field_of_view_span>(
          {.key = "field-of-view-span",
           .label = "Field of view spans",
           .help = {"What the viewport spans: the picture from border to border, or from the first pixel's sample to "
                    "the last one's.",
                    "CGPP 15.4.1", "Confusing the two magnifies the picture by width / (width - 1)."},
           .keywords = "fov, field of view, frustum, pixel centre, pixel center",
           .truth = other_picture(),
           .known_to = {.fast = any_value, .hardware = any_value},
           .shown_by = {.experiments = none, .scenes = {{"cgfs/reflections"}}}},
          {{"edges", "pixel edges", "The viewport's borders are the picture's borders."},
           {"centres", "pixel centres", "The viewport's borders run through the outermost samples."}}),
      toggle<&Settings::camera_relative>(
          {.key = "camera-relative",
           .label = "Relative to the camera",
           .help = {"Subtracts an origin near the scene from geometry, lights and camera before rounding to float; the "
                    "rasterizer then subtracts the camera position, too.",
                    "the floating origin of large worlds; LAB 7",
                    "Off: coordinates a million units from the origin jump between floats that are 1/16 unit apart."},
           .keywords = "floating origin, large world, jitter, precision, far from origin, float",
           .truth = exactly("camera-relative=on"),
           .acts_for = ActsFor::rays | ActsFor::fragments,
           .known_to = {.fast = {knows(whole_tiles, 30, true)}, .hardware = defined_as("CAMERA_RELATIVE")},
           .shown_by = {.experiments = {{"far-from-origin", is<&Settings::camera_relative, false>,
                                         "camera-relative=on"},
                                        {"world-offset-sphere-acne"}},
                        .scenes = {{"lab/far-origin"}}}}),
      real<&Settings::near>(
          {.key = "near",
           .label = "Near limit",
           .help = {"Surfaces nearer than this are not seen. Ray tracer: minimum t of an eye ray (t = 1 is the "
                    "viewport). Rasterizer: distance of the near plane, in projection-plane distances.",
                    "CGFS ch. 2 and 11", "Too small: wastes depth precision. Too large: cuts holes into near objects."},
           .keywords = "near plane, clip plane, frustum, t min, z near",
           .truth = as_set(),
           .known_to = {.fast = any_value, .hardware = any_value},
           .shown_by = {.experiments = {{"near-plane"}, {"near-plane-cuts-volume"}}, .scenes = {{"lab/z-fighting"}}}},
          1e-4, 1e4, OptionScale::logarithmic, "d"),
      far,
  };
}

}  // namespace ps::rows
