#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "engine/figure_shapes.h"
#include "engine/figure_values.h"

namespace ps {

/// A figure that follows from its parameters by formulas of the subject.
struct FigureKind {
  std::string_view name;
  void (*draw)(FigureValues& values, FigureMarks& marks);
};

/// Kinds about directions, about intervals and cells, and about the screen.
std::span<const FigureKind> ray_figures();
std::span<const FigureKind> interval_figures();
std::span<const FigureKind> raster_figures();

/// Returns nullptr for an unknown name.
const FigureKind* find_figure_kind(std::string_view name);
std::vector<std::string_view> figure_kind_names();

}  // namespace ps
