#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "options/settings.h"
#include "scene/scene.h"

/// A listing is a lesson's routine, written in the steps of its source: chapters/NAME/listing.cpp. The textbook
/// renderer runs it unchanged, in double precision, and the window shows its lines with the values that they had for
/// a pixel.

namespace ps {

struct BookScene;
class BookCanvas;

/// How a listing goes about a picture.
enum class ListingOrder {
  pixel_by_pixel,   ///< it may be asked for any part of the canvas alone
  object_by_object  ///< it goes through everything that is drawn, whichever pixels are wanted
};

/// The parts of a scene that a listing shows. All of them leave out planes, boxes, cylinders and CSG, the attenuation
/// of lights, and maps of anything but colours and normals.
struct ListingDraws {
  bool spheres = false;
  bool models = false;  ///< made of triangles
  bool canvas_lines = false;
  bool canvas_triangles = false;
  bool canvas_intensities = false;  ///< the intensities h at their vertices
  bool canvas_gradients = false;    ///< vertices of different colours
  bool light = false;
  bool light_colours = false;  ///< other than white
  bool tints = false;          ///< colours of their own for highlights and ambient light
  bool shadows = false;
  bool reflections = false;
  bool textures = false;
  bool normal_maps = false;
};

struct Listing {
  std::string_view label;   ///< "shadows and reflections"
  std::string_view source;  ///< "CGFS ch. 4"
  std::string_view shows;   ///< one sentence: what it can show
  ListingOrder order = ListingOrder::pixel_by_pixel;
  /// Keys of the options that it reads.
  std::vector<std::string_view> reads;
  ListingDraws draws;
  /// Sets the options that say what it does by its nature, beyond what it draws and in which order: "wireframe". What
  /// it reads stays as it is. May be nullptr.
  void (*as_settings)(Settings&) = nullptr;
  /// How well it suits a scene with these traits and settings; 0 = it shows no part of it,
  /// and below 0 it is not chosen for a scene that no listing shows either.
  int (*suits)(const SceneTraits&, const Settings&) = nullptr;
  /// Draws the scene. Colours are those of the book, 0 to 255.
  void (*draw)(const BookScene&, BookCanvas&) = nullptr;
};

struct NamedListing {
  std::string folder;  ///< of the lesson: "cgfs_04_shadows_and_reflections"
  std::string key;     ///< of the option's choice: "cgfs-04-shadows-and-reflections"
  const Listing* listing = nullptr;
  std::string bug{};  ///< the file of the bug that is planted in it: "missing_lines"; empty: none
};

/// All listings, in the order of their folders.
std::span<const NamedListing> listings();

/// The one that the settings name or, with listing = auto, the one that suits best; of equals the earlier one.
const NamedListing& listing_of(const Settings& settings, const SceneTraits& traits);

/// A listing in which one line is wrong, for students to find: chapters/FOLDER/bugs/NAME.bug.
struct ListingBug {
  std::string_view folder;   ///< of the lesson
  std::string_view name;     ///< of the file: "missing_lines"
  std::string key;           ///< of the option's choice: "missing-lines"
  std::string label;         ///< "missing lines"
  std::string_view symptom;  ///< one sentence: what is seen
  const Listing* listing = nullptr;
};

/// All bugs, in the order of their folders and names.
std::span<const ListingBug> listing_bugs();

/// The listing that runs: that of listing_of(), with the bug that the settings name if it is one of that listing.
NamedListing running_listing(const Settings& settings, const SceneTraits& traits);

/// Whether the listing looks at the option.
bool listing_reads(const NamedListing& listing, std::string_view option);

}  // namespace ps
