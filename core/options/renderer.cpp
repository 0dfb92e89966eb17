#include "options/listing.h"
#include "options/renderer_kind.h"
#include "options/rows.h"

namespace ps {

PictureWay picture_way(Renderer renderer) {
  switch (renderer) {
  case Renderer::ray_tracer:
    return PictureWay::rays;
  case Renderer::rasterizer:
    return PictureWay::fragments;
  case Renderer::textbook:
    return PictureWay::listing;
  }
  return PictureWay::rays;
}

}  // namespace ps

namespace ps::rows {
namespace {

Option listing_row() {
  Option option = row<&Settings::listing>(
      {.key = "listing",
       .label = "Listing",
       .help = {"Which lesson's routine the textbook renderer runs.", "CGFS, chapter by chapter",
                "A listing draws only what its chapter knows: a chapter on lines leaves spheres out."},
       .truth = exactly("renderer=ray-tracer"),
       .inactive = [](const Settings& s, const SceneTraits&) -> Reason {
         if (!runs_listing(s.renderer)) return "only textbook listings use it";
         return {};
       }},
      OptionKind::choice);
  option.choices.push_back(
      {"auto", "what suits the scene", "The last chapter that still says something of this scene."});
  for (const NamedListing& listing : listings())
    option.choices.push_back({listing.key, listing.listing->label, listing.listing->shows});
  option.maximum = static_cast<double>(option.choices.size()) - 1;
  return option;
}

}  // namespace

std::vector<Option> renderer_rows() {
  return {
      choice<&Settings::renderer>(
          {.key = "renderer",
           .label = "Renderer",
           .help = {"Which algorithm makes the picture: one ray for each pixel, or one loop over "
                    "the pixels of each triangle.",
                    "CGFS parts I and II",
                    "Spheres are exact for rays and made of triangles for the rasterizer, so "
                    "their outlines may differ by a pixel."},
           .truth = exactly("renderer=ray-tracer")},
          {{"ray-tracer", "ray tracer", "For each pixel: which surface does its ray meet first?"},
           {"rasterizer", "rasterizer", "For each triangle: which pixels does it cover?"},
           {"textbook", "textbook listing", "The short routine of a lesson, line by line as its source tells it."}}),
      listing_row(),
      toggle<&Settings::demo_slips>(
          {.key = "demo-slips",
           .label = "Demo's slips",
           .help = {"Whether a listing keeps what the author's own program does wrong, or cures it.",
                    "the programs that accompany CGFS",
                    "With the slip, highlights are right only for a camera at the origin."},
           .truth = exactly("demo-slips=off"),
           .inactive = [](const Settings& s, const SceneTraits&) -> Reason {
             if (!runs_listing(s.renderer)) return "only textbook listings use it";
             return {};
           }}),
  };
}

}  // namespace ps::rows
