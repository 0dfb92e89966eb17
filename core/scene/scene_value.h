#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "math/vec.h"
#include "scene/scene_tree.h"

namespace ps {

/// Turns terms of one scene file into numbers, vectors, colours and rotations. Every function throws InputError naming
/// the file, line and column of the term, what was found and what was expected.
class SceneValues {
 public:
  explicit SceneValues(std::string file) : file_(std::move(file)) {}
  const std::string& file() const { return file_; }

  [[noreturn]] void fail(const SceneTerm& term, const std::string& expected) const;
  [[noreturn]] void fail_at(int line, int column, const std::string& found, const std::string& expected) const;

  /// A finite number with a magnitude of at most `max_scene_number`.
  double number(const SceneTerm& term, std::string_view expected = "a number") const;
  double positive(const SceneTerm& term) const;
  double in_range(const SceneTerm& term, double low, double high) const;
  int whole(const SceneTerm& term, int low, int high) const;
  bool on_off(const SceneTerm& term) const;
  /// A word or a quoted text, not empty.
  std::string name(const SceneTerm& term, std::string_view expected = "a name") const;

  /// The three terms of a list, one for each vertex of a triangle.
  const std::vector<SceneTerm>& corners(const SceneTerm& term) const;
  Vec2d vec2(const SceneTerm& term) const;
  Vec3d vec3(const SceneTerm& term) const;
  /// Like vec3, but not (0, 0, 0). Its length has no meaning: one that renderers could not square comes back longer.
  Vec3d direction(const SceneTerm& term) const;
  /// Like vec3, but not (0, 0, 0), and with the length that it has: a side of a rectangle.
  Vec3d side(const SceneTerm& term) const;
  /// An axis of the camera's frame, whose length is a scale of the picture; at least `min_camera_axis` long.
  Vec3d camera_axis(const SceneTerm& term) const;
  /// (r, g, b) from 0 to 255, a colour's name, or linear (r, g, b) with numbers from 0 up. Returned with 255 = 1.
  Vec3d colour(const SceneTerm& term) const;
  /// 600 x 400, written with or without blanks.
  Vec2d size(const SceneTerm& term) const;
  /// <45 degrees around the Y axis>, several of them with commas (the first turns first), or three rows in [ ].
  Mat3d rotation(const SceneTerm& term) const;
  /// A rotation that is a frame of its own, of a camera or a box: no column is shorter than `min_camera_axis`.
  Mat3d frame(const SceneTerm& term) const;
  /// The exponent of a highlight: greater than 0, or the book's -1 for a matte surface, which has none.
  std::optional<double> specular(const SceneTerm& term) const;
  /// Scale factors: one number for all axes or three; not zero.
  Vec3d scale(const SceneTerm& term) const;

 private:
  std::string file_;
};

/// Larger numbers would overflow float arithmetic inside the renderers.
inline constexpr double max_scene_number = 1e12;
/// Rays in float could not square shorter axes of a camera.
inline constexpr double min_camera_axis = 1e-9;
inline constexpr double min_refraction_index = 0.1, max_refraction_index = 10;

/// The whole of `text` as a finite decimal number; nullopt if it is anything else (hexadecimal, "nan", "1,5",
/// overflow).
std::optional<double> parse_finite(std::string_view text);

}  // namespace ps
