#include "raster/pass.h"

#include "raster/multisample.h"
#include "raster/renderer.h"

namespace ps::raster {
namespace {

using Textures = std::vector<MipChain>;

/// The textures with the levels that the filter reads.
std::shared_ptr<const Textures> mip_chains(const Scene& scene, TextureFilter filter, Prepared& prepared) {
  const bool levels = filter == TextureFilter::trilinear || filter == TextureFilter::mipmap;
  const MipLevels which = levels ? MipLevels::all : MipLevels::finest_only;
  return prepared.get<Textures>(Key("raster-textures").add(scene.textures.revision()).add(which), [&] {
    Textures chains;
    for (const Texture& texture : *scene.textures) {
      chains.push_back(make_mip_chain(texture.texels, which));
      chains.back().clamped = texture.clamped;
    }
    return chains;
  });
}

/// The same in the form that the fast path reads.
std::shared_ptr<const std::vector<PackedTexture>> pack_textures(const Scene& scene, const Settings& settings,
                                                                const Textures& chains, Prepared& prepared) {
  const TextureFilter filter = settings.texture_filter;
  const bool levels = filter == TextureFilter::trilinear || filter == TextureFilter::mipmap;
  const Key key = Key("raster-packed-textures")
                      .add(scene.textures.revision())
                      .add(std::uint64_t{levels})
                      .add(settings.texture_wrap);
  return prepared.get<std::vector<PackedTexture>>(key, [&] {
    std::vector<PackedTexture> packed;
    for (const MipChain& chain : chains) packed.push_back(pack_texture(chain, wrap_of(chain, settings)));
    return packed;
  });
}

}  // namespace

template <class Real>
Pass<Real> make_pass(const Scene& scene, const View& view, const Settings& settings, Channel channels,
                     Prepared& prepared) {
  Pass<Real> pass;
  pass.scene = &scene;
  pass.settings = settings;
  pass.channels = channels;
  pass.viewport = make_viewport<double>(view, settings);
  pass.projection = make_canvas_projection<Real>(pass.viewport);
  pass.camera_space = make_camera_space(view.camera);
  pass.camera = view.camera;
  pass.eye = Vec3<Real>(view.camera.position);
  pass.backward = Vec3<Real>(-view.camera.forward);
  pass.planes = make_clip_planes<Real>(settings, pass.viewport);
  pass.grid = {settings.subpixel_bits, settings.fill_rule, pass.viewport.sample, sample_count(settings.multisampling)};
  pass.coverage = {settings.coverage, settings.edge_arithmetic};
  pass.depth = make_depth_code(settings, pass.viewport.distance);
  pass.lights = shading_lights<Real>(*scene.lights, settings.light_shown);
  pass.objects = make_draw_list(scene, view, settings, pass.viewport, prepared);
  const LightNeeds needs = light_needs(*scene.lights);
  bool textured = false;
  for (const DrawObject& object : pass.objects) {
    pass.first_surface.push_back(static_cast<std::uint32_t>(pass.surfaces.size()));
    for (const std::uint32_t index : object.materials) {
      const Material& material = scene.materials->at(index);
      Surface<Real> surface;
      surface.object = object.object;
      surface.drawn = pass.first_surface.size() - 1;
      surface.sphere = object.sphere;
      surface.layout = make_layout(settings, needs, material, *object.mesh, channels);
      surface.material = shading_material<Real>(material);
      pass.surfaces.push_back(surface);
      textured = textured || surface.layout.tangents != AttributeLayout::absent || surface.layout.reflection_map ||
                 (settings.textures && surface.layout.uv != AttributeLayout::absent && needs_uv(material));
    }
  }
  pass.path = rasterized_fast_path(settings, prepared_traits(scene, prepared), channels);
  if constexpr (std::is_same_v<Real, float>)
    if (pass.path.machinery != Machinery::clear) {
      pass.shade_batch = shade_function(settings.simd);
      pass.scan_triangle = scan_function(settings.simd);
    }
  if (textured) {
    pass.textures = mip_chains(scene, settings.texture_filter, prepared);
    if (pass.shade_batch) pass.packed_textures = pack_textures(scene, settings, *pass.textures, prepared);
  }
  return pass;
}

template Pass<float> make_pass(const Scene&, const View&, const Settings&, Channel, Prepared&);
template Pass<double> make_pass(const Scene&, const View&, const Settings&, Channel, Prepared&);

}  // namespace ps::raster
