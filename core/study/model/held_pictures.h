#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "render/render.h"
#include "study/control.h"

namespace ps::model {

/// How far the pictures of a smaller model are from those of the full one.
struct Change {
  double increase = 0;  ///< in the worst tile of all pictures: what the smaller model adds to its FLIP
  double rmse = 0;      ///< of the picture that differs most, in display levels
};

/// The pictures that a smaller model must still show: from every view, by rays and by fragments.
class HeldPictures {
 public:
  /// Renders the full scene. Throws Cancelled, as do the other members.
  HeldPictures(const Scene& full, std::vector<View> views, const Settings& settings, StudyControl& control,
               WorkerPriority priority);

  /// Renders the scene afresh in all pictures and compares each tile with that of the full scene. Stops at the first
  /// picture that changes by more than `enough`.
  Change change(const Scene& scene, const Settings& settings, double enough = 1);

  /// From here on a tile of a picture by rays may differ if it is no farther from the mean over the pixel than that of
  /// the full scene. Rays read one texel where a pixel covers many; a coarser texture shows their mean, which is
  /// another picture and a better one.
  void allow_means();

  /// Counted work of the pictures by the renderer that was asked for, each a quarter as wide and high.
  std::uint64_t work(const Scene& scene, const Settings& settings) const;
  /// The change of pictures of that size, for what is tried by the dozen.
  Change small_change(const Scene& scene, const Settings& settings);

  /// The smallest gap behind a visible surface in the pictures of work(), by fragments, in units of the depth buffer
  /// (Channel::depth_gap). Infinity where no surface hides another.
  double smallest_depth_gap(const Scene& scene, const Settings& settings) const;

  /// The share of the pixels of such a picture in which float shows another surface than double, where it is most: the
  /// faults of the precision map but for shading, which a comparison of colours sees.
  double wrong_in_float(const Scene& scene, Settings settings) const;

  /// The settings by rays and by fragments.
  static Settings by_rays(Settings settings);
  static Settings by_fragments(Settings settings);
  int rendered() const { return rendered_; }

 private:
  struct Held {
    View view;
    bool rays = false;
    Image<Rgb8> levels;
    std::optional<Image<Rgb8>> mean;
    std::vector<double> from_mean;  ///< tile_flips() of `levels` against the mean
  };
  Frame frame_of(const Scene& scene, const View& view, const Settings& settings, Prepared& prepared,
                 Channel channels = Channel::none) const;
  Image<Rgb8> levels_of(const Scene& scene, const Held& held, const Settings& settings, Prepared& prepared) const;
  std::vector<Held> hold(const std::vector<View>& views) const;
  Change change_of(const std::vector<Held>& held, const Scene& scene, const Settings& settings, double enough) const;

  Scene full_;
  std::vector<View> views_, small_views_;
  Settings settings_;
  StudyControl& control_;
  WorkerPriority priority_;
  std::vector<Held> held_, held_small_;
  mutable int rendered_ = 0;
};

}  // namespace ps::model
