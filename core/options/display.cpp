#include "options/rows.h"

namespace ps::rows {

std::vector<Option> display_rows() {
  return {
      real<&Settings::exposure>({.key = "exposure",
                                 .label = "Exposure",
                                 .help = {"Linear colours are multiplied by this before display.", "CGPP 15.3.2",
                                          "Values above 1 are clipped."},
                                 .keywords = "brightness, tone mapping, gain, overexposed, clipping",
                                 .truth = other_picture(),
                                 .acts_for = ActsFor::picture,
                                 .effect = OptionEffect::display,
                                 .known_to = {.fast = any_value, .hardware = any_value},
                                 .shown_by = {.experiments = none, .scenes = {{"cgfs/reflections"}}}},
                                1e-3, 1e3, OptionScale::logarithmic),
      real<&Settings::gamma>({.key = "gamma",
                              .label = "Gamma",
                              .help = {"Displayed value = linear value to the power 1 / gamma.", "CGPP 15.3.2",
                                       "The book's colours are display values already: gamma 1."},
                              .keywords = "sRGB, tone mapping, brightness, linear, banding",
                              .truth = other_picture(),
                              .acts_for = ActsFor::picture,
                              .effect = OptionEffect::display,
                              .known_to = {.fast = any_value, .hardware = any_value},
                              .shown_by = {.experiments = {{"srgb-averaging"}}, .scenes = {{"cgfs/reflections"}}}},
                             0.1, 5, OptionScale::linear),
      choice<&Settings::colour_depth>(
          {.key = "colour-depth",
           .label = "Colour depth",
           .help = {"Number of bits of a displayed pixel.", "CGFS ch. 1", "Too few: bands in smooth gradients."},
           .keywords = "banding, quantization, quantisation, bits per pixel, color depth, high color, posterize",
           .truth = exactly("colour-depth=24"),
           .acts_for = ActsFor::picture,
           .effect = OptionEffect::display,
           .known_to = {.fast = any_value, .hardware = any_value},
           .shown_by = {.experiments = none, .scenes = {{"cgfs/reflections"}}}},
          {{"24", "24 bits", "8 for each of red, green and blue."},
           {"16", "16 bits", "5 red, 6 green, 5 blue."},
           {"15", "15 bits", "5 for each."}}),
  };
}

}  // namespace ps::rows
