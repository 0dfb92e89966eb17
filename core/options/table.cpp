#include "options/option.h"
#include "options/rows.h"

namespace ps {
namespace {

void append(std::vector<Option>& table, std::string_view group, std::vector<Option> rows) {
  for (Option& row : rows) {
    row.group = group;
    table.push_back(std::move(row));
  }
}

std::vector<Option> make_table() {
  std::vector<Option> table;
  append(table, "Renderer", rows::renderer_rows());
  append(table, "Camera", rows::camera_rows());
  append(table, "Sampling", rows::sampling_rows());
  append(table, "Visibility", rows::visibility_rows());
  append(table, "Drawing", rows::drawing_rows());
  append(table, "Shading", rows::shading_rows());
  append(table, "Textures", rows::texture_rows());
  append(table, "Shadows", rows::shadow_rows());
  append(table, "Reflection", rows::reflection_rows());
  append(table, "Intersection", rows::intersection_rows());
  append(table, "Speed", rows::speed_rows());
  append(table, "Display", rows::display_rows());
  for (Option& option : table) rows::say_fast_limits(option);
  return table;
}

}  // namespace

std::span<const Option> option_table() {
  static const std::vector<Option> table = make_table();
  return table;
}

}  // namespace ps
