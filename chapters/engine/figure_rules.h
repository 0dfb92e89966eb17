#pragma once
#include <array>
#include <utility>
#include <vector>

#include "math/vec.h"

/// The formulas from which the kinds of figures follow.

namespace ps {

/// A part of a ray, from a smaller t to a larger one.
using FigureInterval = std::pair<double, double>;

enum class FigureOperation { join, overlap, cut };  ///< A or B; A and B; A without B

/// The parts of a ray that a Boolean operation keeps of two solids: where the operation holds. Sorted, without empty
/// parts.
std::vector<FigureInterval> combined(const std::vector<FigureInterval>& a, const std::vector<FigureInterval>& b,
                                     FigureOperation operation);

/// R = 2 N (N · L) - L, for a normal of length 1.
Vec2d reflected(const Vec2d& to_light, const Vec2d& normal);

/// The edge function of the edge from `a` to `b` at `p`: positive on its left, twice the area of the triangle a b p.
double edge_value(const Vec2d& a, const Vec2d& b, const Vec2d& p);

/// The depth at the share `s` of a span on the screen: 1/z is linear there.
double depth_on_screen(double first, double last, double s);

/// Where lines through a, b and c, d meet; they must not be parallel.
Vec2d meeting(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d);

/// t of the places where the ray from `origin` along `direction` meets a circle, smaller first; none if it misses.
std::vector<double> circle_hits(const Vec2d& origin, const Vec2d& direction, const Vec2d& middle, double radius);

/// A square cell of a tree.
struct FigureCell {
  Vec2d low{0, 0};
  double size = 1;
  int count = 0;  ///< of the points inside
};

/// The leaves of a quadtree over a square: a cell with more than `most` points is divided in four, down to `depth`.
std::vector<FigureCell> quadtree_leaves(const std::vector<Vec2d>& points, const FigureCell& root, int most, int depth);

/// How far a pixel reaches on flat ground.
struct Footprint {
  double near = 0, far = 0;              ///< distance of its lower and upper edge from below the eye
  double near_width = 0, far_width = 0;  ///< across, at those
};

/// The footprint of a pixel `pixel` wide and high on a screen at distance 1, whose centre looks at the ground
/// `distance` away from an eye `height` above it. The screen is vertical.
Footprint footprint_of(double height, double distance, double pixel);

}  // namespace ps
