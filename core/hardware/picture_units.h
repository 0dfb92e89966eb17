#pragma once

namespace ps::hardware {

/// Where the drawer binds what shaders read. Textures of a surface have the units from 0 on.
inline constexpr unsigned lights_binding = 0, maps_binding = 1;
inline constexpr int maps_unit = 7, environment_unit = 8, surface_table_unit = 9, geometry_unit = 10, samples_unit = 15;

}  // namespace ps::hardware
