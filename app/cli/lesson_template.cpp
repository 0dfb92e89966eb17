#include "cli/lesson_template.h"

#include <fmt/format.h>

#include "options/renderer_kind.h"

namespace ps::cli {
namespace {

constexpr std::string_view before_renderer = R"(# A title of your own
source: where it comes from

What is above the first step introduces the lesson. The fenced block below holds for all steps. A scene of your own lies
in this folder and begins with `./`; the names of built-in scenes are listed by `pixelscope-cli scenes`.

```settings
scene ./balls.scene
set-both renderer=)";

constexpr std::string_view behind_renderer = R"(
```

```goals
say how much the shadows darken
count the rays of shadows
read the story of a pixel
```

## The first step

A step is a heading, its text, a block of settings and what to look for. Picture A has shadows here, picture B has none.
A name in bold, such as **Shadows**, leads to the option. Write a control into the text like this: [[shadows]].

```settings
set-b shadows=none
pixel 200,402
```

The next block is a claim: a sentence, what is measured for it, the bound, and a mutation that must break it. The claim
is measured while the step is open.

```claim
text The shadows cover more than 20,000 pixels.
metric differing-pixels
bound >= 20000
mutation shadows
```

> Lines like this one say what to look for. They are shown after the question is answered, where there is one.

## A step that asks

A question covers the picture that would answer it. The right answer is measured and is never written down.

```settings
set-b shadows=none
pixel 200,402
```

```question
ask choice
text How many shadow rays does B cast?
metric counter-b shadow-rays
choice = 0: None at all. | A surface in B never asks whether a light is blocked.
choice = 360000: One for each pixel. | That would be the number of eye rays.
why The option Shadows is set to none in B.
hide b
```

> Compare the two pictures where the balls touch the ground: only A has shadows there.

## A question with a number

A number is right within a tolerance. There are also `ask click` for a place in a picture, and `ask colour`, `winner`,
`rays`, `triangle` and `tests`, which are about the picked pixel.

```settings
size 300x200
```

```question
ask number
text How many eye rays does A cast with one ray for each pixel?
metric counter-a eye-rays
tolerance 600
unit rays
why The picture has 300 columns and 200 rows.
```

> The line under picture A gives the number of all its rays.

## An edit of the scene

Lines that begin with `edit` change the scene for both pictures: a light, an object or the camera. The first light of this
scene lights all surfaces alike. In this step it is off, so what faces away from the other lights is black.

```settings
edit light.0.intensity 0
set-both shadows=none
pixel 110,520
```

```claim
text The red ball is black where it faces away from both other lights.
metric red-a
bound = 0
mutation edit light.0.intensity 0.2
```

> Click around the outline of the red ball: the story says from which lights the surface faces away.

## What an option costs

The last step compares the work of A and B. A sends four rays for each pixel, B one, so the bound follows from the options
alone. Take your bounds from such a formula or from a source, and name it in the text.

```settings
size 300x200
set samples-per-pixel=4
```

```claim
text A sends four times as many eye rays as B.
metric counter-ratio eye-rays
bound = 4
mutation samples-per-pixel
```

> Zoom into an outline: A has pixels between the colour of the ball and that of the ground, B has none.
)";

}  // namespace

std::string lesson_template() {
  return fmt::format("{}{}{}", before_renderer, renderer_kind(renderer_for(PictureWay::rays)).key, behind_renderer);
}

const std::string_view lesson_template_scene =
    R"(# A scene of your own. Sizes are in units of the world, colours from 0 to 255.
title = "Two balls"
canvas_size = 600 x 600
viewport_size = 1 x 1
projection_plane_d = 1
background = white
start_pixel = (200, 402)

sphere {
    name = red
    center = (0, -1, 3)
    radius = 1
    color = (255, 0, 0)
    specular = 500
}

sphere {
    name = green
    center = (-2, 0, 4)
    radius = 1
    color = (0, 255, 0)
    specular = 10
}

sphere {
    name = ground
    center = (0, -5001, 0)
    radius = 5000
    color = (255, 255, 0)
    specular = 1000
}

light { type = ambient  intensity = 0.2 }
light { type = point  intensity = 0.6  position = (2, 1, 0) }
light { type = directional  intensity = 0.2  direction = (1, 4, 4) }
)";

}  // namespace ps::cli
