#include <lessons_table.h>

#include <algorithm>
#include <vector>

#include "base/check.h"
#include "options/listing.h"
#include "options/renderer_kind.h"
#include "options/rows.h"

namespace ps {
namespace {

/// A listing reads what it says; the choice of listing, the display and the machine act for all of them.
std::optional<bool> listing_uses(const Option& option, const Settings& settings, const SceneTraits& traits) {
  if (listing_reads(listing_of(settings, traits), option.key)) return true;
  if (option.effect != OptionEffect::picture || acts_for(option.acts_for, PictureWay::listing)) return {};
  return false;
}

/// In the order of the enum Renderer, then those that were added.
std::vector<RendererKind>& kinds() {
  static std::vector<RendererKind> all{{.key = "ray-tracer",
                                        .label = "ray tracer",
                                        .help = "Finds for each pixel the surface that its ray meets first.",
                                        .way = PictureWay::rays},
                                       {.key = "rasterizer",
                                        .label = "rasterizer",
                                        .help = "Finds for each triangle the pixels that it covers.",
                                        .way = PictureWay::fragments},
                                       {.key = "textbook",
                                        .label = "textbook listing",
                                        .help = "Runs the short routine of a lesson, line by line as in its source.",
                                        .way = PictureWay::listing,
                                        .reads = listing_uses,
                                        .unread = "the listing does not use it"}};
  return all;
}

bool listed = false;  ///< by the option table, which does not change afterwards

}  // namespace

bool acts_for(ActsFor set, PictureWay way) {
  return (static_cast<unsigned>(set) >> static_cast<unsigned>(way) & 1u) != 0;
}

std::span<const RendererKind> renderer_kinds() { return kinds(); }

const RendererKind& renderer_kind(Renderer renderer) {
  const auto number = static_cast<std::size_t>(renderer);
  PS_ASSERT(number < kinds().size(), "the number of a renderer");
  return kinds()[number];
}

Renderer add_renderer_kind(const RendererKind& kind) {
  PS_ASSERT(!listed, "renderers are added before the option table is used");
  kinds().push_back(kind);
  kinds().back().added = true;
  return static_cast<Renderer>(kinds().size() - 1);
}

Renderer renderer_for(PictureWay way) {
  std::size_t number = 0;
  while (kinds().at(number).way != way) ++number;
  return static_cast<Renderer>(number);
}

}  // namespace ps

namespace ps::rows {

Truth averaged_by_rays() { return pixel_average("renderer=ray-tracer"); }

namespace {

Option renderer_row() {
  Option option = row<&Settings::renderer>(
      {.key = "renderer",
       .label = "Renderer",
       .help = {"The algorithm that makes the picture: one ray for each pixel, or one loop over the pixels of each "
                "triangle.",
                "CGFS parts I and II",
                "Rays meet exact spheres; the rasterizer draws spheres as triangles, so outlines may differ by a "
                "pixel."},
       .keywords = "ray tracing, ray casting, path, rasterization, rasterisation, software renderer, scanline renderer",
       .truth = averaged_by_rays(),
       .acts_for = ActsFor::picture,
       .known_to = {.fast = any_value, .hardware = any_value},
       .shown_by = {.experiments = none, .scenes = {{"cgfs/reflections"}}}},
      OptionKind::choice);
  listed = true;
  for (const RendererKind& kind : renderer_kinds())
    option.choices.push_back({kind.key, kind.label, kind.help, kind.inactive});
  option.maximum = static_cast<double>(option.choices.size()) - 1;
  return option;
}

Option listing_row() {
  Option option = row<&Settings::listing>(
      {.key = "listing",
       .label = "Listing",
       .help = {"The lesson's routine that the textbook renderer runs.", "CGFS, chapter by chapter",
                "A listing draws only what its chapter covers: a chapter on lines leaves out spheres."},
       .keywords = "code, source, routine, chapter, pseudocode",
       .truth = averaged_by_rays(),
       .acts_for = ActsFor::listings,
       .known_to = {.fast = any_value, .hardware = not_asked},
       .shown_by = {.experiments = none,
                    .scenes = {{"cgfs/depth", "backface-culling=off"},
                               {"lab/polygon-rows", "listing=lab-cornell"},
                               {"cgfs/reflections"},
                               {"cgfs/camera"},
                               {"cgfs_01_pixels_and_colours/overlap.scene"},
                               {"cgfs_15_relief/mirrored.scene"},
                               {"cgfs/crates"},
                               {"cgfs/shading"},
                               {"cgfs/behind"}}}},
      OptionKind::choice);
  option.choices.push_back({"auto", "automatic", "Automatic: the most advanced listing that can draw this scene."});
  for (const NamedListing& listing : listings())
    option.choices.push_back({listing.key, listing.listing->label, listing.listing->shows});
  option.maximum = static_cast<double>(option.choices.size()) - 1;
  return option;
}

Reason unless_it_runs(std::string_view folder, const Settings& settings, const SceneTraits& traits) {
  return listing_of(settings, traits).folder == folder
             ? Reason{}
             : IdleReason(IdleReason::Kind::renderer, "a bug of another listing");
}

Reason listing_has_no_bugs(const Settings& settings, const SceneTraits& traits) {
  const std::string& folder = listing_of(settings, traits).folder;
  const auto all = listing_bugs();
  const bool has = std::any_of(all.begin(), all.end(), [&](const ListingBug& bug) { return bug.folder == folder; });
  return has ? Reason{} : IdleReason(IdleReason::Kind::renderer, "this listing has no variants with a bug");
}

std::vector<Choice> bug_choices() {
#define PS_INACTIVE(folder, bug, symptom)                                                                              \
  [](const Settings& settings, const SceneTraits& traits) { return unless_it_runs(#folder, settings, traits); },
  constexpr decltype(Choice::inactive) inactive[] = {PS_LISTING_BUGS(PS_INACTIVE)};
#undef PS_INACTIVE
  std::vector<Choice> choices{{"none", "none", "The listing as it should be."}};
  for (const ListingBug& bug : listing_bugs())
    choices.push_back({bug.key, bug.label, bug.symptom, inactive[choices.size() - 1]});
  return choices;
}

Option listing_bug_row() {
  return choice<&Settings::listing_bug>(
      {.key = "listing-bug",
       .label = "Planted bug",
       .help = {"Runs a copy of the listing in which one line is wrong. Find it in the panel Listing.",
                "exercises of the lessons", "Each bug is named after what is seen, and belongs to one listing."},
       .keywords = "bug, mistake, exercise, debugging, wrong line, find the bug",
       .truth = exactly("listing-bug=none"),
       .acts_for = ActsFor::listings,
       .inactive = listing_has_no_bugs,
       .known_to = {.fast = any_value, .hardware = not_asked},
       .shown_by = {.experiments = none,
                    .scenes = {{"cgfs/spheres"},
                               {"cgfs_01_pixels_and_colours/overlap.scene", "listing=cgfs-01-pixels-and-colours"},
                               {"cgfs/reflections"},
                               {"cgfs/crates"},
                               {"cgfs/lights"},
                               {"cgfs_04_shadows_and_reflections/balloon.scene"},
                               {"cgfs_06_lines/ends.scene"},
                               {"cgfs/cubes", "listing=cgfs-10-scenes"},
                               {"cgfs/shading"},
                               {"cgfs_15_shadows_in_the_rasterizer/yard.scene"},
                               {"cgfs_11_clipping/two.scene", "listing=cgfs-11-clipping"},
                               {"cgpp/ground", "listing=cgpp-15-4-measured-light"},
                               {"cgfs/shaded-triangle"},
                               {"cgpp_15_6_exact_edges/fan.scene", "listing=cgpp-15-6-exact-edges"},
                               {"cgfs_07_filled_triangles/square.scene"},
                               {"cgfs/depth", "backface-culling=off"},
                               {"cgfs/depth", "backface-culling=on"},
                               {"lab/polygon-rows", "listing=lab-cornell"},
                               {"cgfs/cubes", "listing=oct-dont-test-everything"},
                               {"cgfs_05_camera/turned.scene", "listing=cgfs-05-camera"},
                               {"cgfs_14_textures/closeup.scene", "listing=cgfs-14-mipmaps"},
                               {"cgfs_15_relief/mirrored.scene", "listing=cgfs-15-relief"},
                               {"cgfs/cubes", "listing=cgfs-05-solids"},
                               {"cgfs_09_perspective/cube.scene", "listing=cgfs-09-perspective"},
                               {"cgfs/cubes", "listing=cgpp-15-6-which-pixels"}}}},
      bug_choices());
}

}  // namespace

std::vector<Option> renderer_rows() {
  return {
      renderer_row(),
      listing_row(),
      listing_bug_row(),
      toggle<&Settings::demo_slips>(
          {.key = "demo-slips",
           .label = "Original bugs",
           .help = {"Reproduces known bugs of the book's demo programs instead of fixing them.",
                    "the programs that accompany CGFS",
                    "Highlights are right only for a camera at the origin. Of four filtered texels the fourth comes "
                    "from the wrong place, which a checkerboard hides. Beyond the texture's edge others are read."},
           .keywords = "bug, mistake, errata",
           .truth = exactly("demo-slips=off"),
           .acts_for = ActsFor::readers,
           .known_to = {.fast = any_value, .hardware = not_asked},
           .shown_by = {.experiments = none, .scenes = {{"cgfs/shading"}}}}),
  };
}

}  // namespace ps::rows
