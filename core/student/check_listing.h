#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/progress.h"
#include "options/listing.h"
#include "student/run_listing.h"
#include "student/wrong_pixel.h"
#include "textbook/trace_listing.h"

namespace ps {

/// A student's own listing beside the one that it is a copy of.
struct CheckedListing {
  OwnRun run;
  Image<Vec3d> right;  ///< the listing's picture, 0 to 255
  WrongPixels wrong;   ///< if the run has a picture
};

/// The settings with which the textbook renderer runs this listing and no bug.
Settings settings_of_listing(const NamedListing& listing, const Settings& settings);

/// The listing's own picture, 0 to 255.
Image<Vec3d> right_picture(const NamedListing& listing, const Scene& scene, const View& view, const Settings& settings,
                           Progress& progress);

/// Runs the program on the scene and compares its picture with that of `listing`. `pixel`: whose values are wanted.
CheckedListing check_listing(const ListingProgram& program, const NamedListing& listing, const Scene& scene,
                             const View& view, const Settings& settings, const std::optional<Vec2i>& pixel,
                             Progress& progress, const RunOptions& options = {});

/// The values as those of a listing in the program, for ListingView. The names in it lie in `trace`.
ListingTrace listing_trace(const OwnTrace& trace, const NamedListing& listing, Vec2i pixel);

/// "Your picture is that of the listing, to the bit.", or how many pixels differ and where the first of them is.
std::string verdict_text(const WrongPixels& wrong, int width, int height);

/// Writes a picture in levels from 0 to 255 as the display shows it, or its numbers from 0 to 1 into a .pfm file.
void save_own_picture(const std::filesystem::path& path, const Image<Vec3d>& picture, const Settings& settings);

}  // namespace ps
