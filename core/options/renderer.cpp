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
       .help = {"The lesson's routine that the textbook renderer runs.", "CGFS, chapter by chapter",
                "A listing draws only what its chapter covers: a chapter on lines leaves out spheres."},
       .truth = exactly("renderer=ray-tracer"),
       .inactive = [](const Settings& s, const SceneTraits&) -> Reason {
         if (!runs_listing(s.renderer)) return "only textbook listings use it";
         return {};
       }},
      OptionKind::choice);
  option.choices.push_back({"auto", "automatic", "Automatic: the most advanced listing that can draw this scene."});
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
           .help = {"The algorithm that makes the picture: one ray for each pixel, or one loop over the pixels of each "
                    "triangle.",
                    "CGFS parts I and II",
                    "Rays meet exact spheres; the rasterizer draws spheres as triangles, so outlines may differ by a "
                    "pixel."},
           .truth = exactly("renderer=ray-tracer")},
          {{"ray-tracer", "ray tracer", "Finds for each pixel the surface that its ray meets first."},
           {"rasterizer", "rasterizer", "Finds for each triangle the pixels that it covers."},
           {"textbook", "textbook listing", "Runs the short routine of a lesson, line by line as in its source."}}),
      listing_row(),
      toggle<&Settings::demo_slips>(
          {.key = "demo-slips",
           .label = "Original bugs",
           .help = {"Reproduces known bugs of the book's demo programs instead of fixing them.",
                    "the programs that accompany CGFS",
                    "With the bug, highlights are right only for a camera at the origin."},
           .truth = exactly("demo-slips=off"),
           .inactive = [](const Settings& s, const SceneTraits&) -> Reason {
             if (!runs_listing(s.renderer)) return "only textbook listings use it";
             return {};
           }}),
  };
}

}  // namespace ps::rows
