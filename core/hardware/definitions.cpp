#include "hardware/definitions.h"

#include <fmt/format.h>

#include "hardware/draw_passes.h"
#include "options/option.h"
#include "raster/setup/textures.h"

namespace ps::hardware {
namespace {

class Lines {
 public:
  Lines& add(std::string_view name, int value) {
    text_ += fmt::format("#define {} {}\n", name, value);
    return *this;
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

/// As the names in shader_text.cpp.
int shading_number(const Settings& settings) {
  if (!settings.lighting || !fills(settings.draw)) return 0;
  switch (settings.shading) {
  case Shading::phong:
    return 1;
  case Shading::gouraud:
    return 2;
  case Shading::flat:
    return 3;
  }
  return 0;
}

int depth_number(DepthValue value) {
  switch (value) {
  case DepthValue::inverse_z:
  case DepthValue::ray_plane:
    return 0;
  case DepthValue::z:
    return 1;
  case DepthValue::distance:
    return 2;
  }
  return 0;
}

/// What holds for the whole picture: options that the shaders know by name, and what follows from several of them.
/// `shading` is 0 where nothing is lit.
Lines of_picture(const PicturePlan& plan, int shading, bool clip_control, ProgramUse use) {
  const Settings& s = plan.settings;
  Lines lines;
  for (const Option& option : option_table())
    if (const std::string_view name = option.known_to.hardware.definition; !name.empty())
      lines.add(name, static_cast<int>(option.get(s)));
  lines.add("PERSPECTIVE", plan.perspective())
      .add("AFFINE", plan.affine())
      .add("SNAPPED", s.vertex_snapping == VertexSnapping::cpu && fills(s.draw))
      .add("CLIP_CONTROL", clip_control)
      .add("SHADING", shading)
      .add("LIGHTS", static_cast<int>(plan.lights.size()))
      .add("ONE_LIGHT", lights_separately(plan))
      .add("TERM_COLOURS", plan.term_colours)
      .add("EXACT_PLACES", plan.exact_places)
      .add("SHADOW_MAPS", plan.maps_shadows)
      .add("DEPTH_BY_SHADER", !driver_keeps_depth(plan, clip_control))
      .add("DEPTH_VALUE", depth_number(plan.depth.value))
      .add("DEPTH_FORMAT", static_cast<int>(plan.depth.format))
      .add("DEPTH_REVERSED", plan.depth.larger_is_nearer())
      .add("STORY", use == ProgramUse::story);
  return lines;
}

}  // namespace

std::string definitions(const PicturePlan& plan, const raster::Surface<float>& surface, bool clip_control,
                        ProgramUse use) {
  const Settings& s = plan.settings;
  const raster::AttributeLayout& layout = surface.layout;
  const ShadingMaterial<float>& material = surface.material;
  const bool filled = fills(s.draw);
  const bool has_uv = filled && s.textures && layout.uv != raster::AttributeLayout::absent;
  const bool normal_map = filled && layout.mapped_normal;
  const bool relief = filled && layout.relief;
  const bool texture = has_uv && material.texture >= 0;
  const bool opacity = has_uv && material.opacity_map >= 0;
  const bool specular_map = has_uv && layout.light_maps && material.specular_map >= 0;
  const bool ambient_map = has_uv && layout.light_maps && material.ambient_map >= 0;
  Lines lines = of_picture(plan, shading_number(s), clip_control, use);
  lines.add("SPECULAR", s.specular && material.specular.has_value())
      .add("INTERPOLATED_NORMAL", layout.normal != raster::AttributeLayout::absent)
      .add("READS_TEXTURES", texture || opacity || specular_map || ambient_map || normal_map || relief)
      .add("TEXTURE", texture)
      .add("OPACITY_MAP", opacity)
      .add("SPECULAR_MAP", specular_map)
      .add("AMBIENT_MAP", ambient_map)
      .add("NORMAL_MAP", normal_map)
      .add("RELIEF", normal_map || relief)
      .add("PARALLAX", relief ? static_cast<int>(s.parallax) : 0)
      .add("MIRRORS", mirrors(plan, surface))
      .add("REFLECTION_MAP", reflects_picture(plan, surface))
      .add("CUBE_CROSS", material.surroundings == Surroundings::cube)
      .add("DEFERRED", plan.defers)
      .add("LIMITS_BY_SHADER", plan.counts_volumes)
      .add("SHADES_WHOLE_PICTURE", 0)
      .add("ANISOTROPY", raster::reads_mip_levels(s.texture_filter) ? s.anisotropy : 1)
      .add("CHANNELS", plan.channels != Channel::none)
      .add("NORMAL_CHANNEL", layout.shading_normal);
  return lines.take();
}

std::string volume_definitions(const PicturePlan& plan, bool clip_control, ProgramUse use) {
  Lines lines = of_picture(plan, 0, clip_control, use);
  lines.add("RELIEF", 0).add("REFLECTION_MAP", 0);
  return lines.take();
}

std::string deferred_definitions(const PicturePlan& plan, bool clip_control, ProgramUse use) {
  Lines lines = of_picture(plan, shading_number(plan.settings), clip_control, use);
  lines.add("RELIEF", 0)
      .add("SPECULAR", plan.settings.specular)
      .add("MIRRORS", plan.mirrors)
      .add("REFLECTION_MAP", 0)
      .add("DEFERRED", 1)
      .add("SHADES_WHOLE_PICTURE", 1)
      .add("TABLE_COLUMNS", surface_table_columns);
  return lines.take();
}

}  // namespace ps::hardware
