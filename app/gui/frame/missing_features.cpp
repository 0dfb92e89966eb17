#include "gui/frame/missing_features.h"

#include <array>

namespace ps::gui {

std::span<const MissingFeature> missing_features() {
  static constexpr std::array all{
      MissingFeature{"depth of field", "bokeh, aperture, focus, lens blur, thin lens", "the pinhole camera",
                     "lesson/cgfs_05_camera"},
      MissingFeature{"ambient occlusion", "AO, SSAO, HBAO, contact shadows, crevice shading", "ambient light",
                     "lesson/cgfs_03_light"},
      MissingFeature{"global illumination", "GI, path tracing, radiosity, photon mapping, indirect light, Monte Carlo",
                     "the Cornell box", "lesson/lab_cornell"},
      MissingFeature{"motion blur", "shutter, moving objects", "several samples for each pixel",
                     "option/samples-per-pixel"},
      MissingFeature{"caustics", "light through glass", "refraction", "lesson/cgfs_05_glass"},
      MissingFeature{"fog", "volumetric, mist, smoke, participating media, god rays", "transparency and refraction",
                     "lesson/cgfs_05_glass"},
      MissingFeature{"subsurface scattering", "SSS, skin, translucency", "light that is measured",
                     "lesson/cgpp_15_4_measured_light"},
      MissingFeature{"microfacet model", "GGX, Cook-Torrance, metallic, roughness", "radiometric illumination",
                     "option/illumination"},
      MissingFeature{"bloom", "glow, lens flare, vignette, post-processing, film grain", "exposure", "option/exposure"},
      MissingFeature{"denoiser", "denoise, noise filter", "more samples for each pixel", "option/samples-per-pixel"},
      MissingFeature{"temporal anti-aliasing", "TAA, FXAA, SMAA, DLSS, upscaling", "anti-aliasing by samples",
                     "technique/anti-aliasing/off"},
      MissingFeature{"signed distance field", "SDF, ray marching, sphere tracing", "solids that are cut and joined",
                     "lesson/cgfs_05_solids"},
      MissingFeature{"frame rate", "fps, frames per second, frame time", "the times of the two pictures",
                     "study-timings"},
      MissingFeature{"histogram", "levels, distribution, waveform", "the difference and its largest pixels",
                     "study-pixels"},
      MissingFeature{"video export", "record a video, gif, animation, keyframes", "pictures of the window",
                     "shot-window"},
      MissingFeature{"glTF import", "gltf, glb, fbx, stl, ply, blend, usd, 3ds, collada", "Wavefront OBJ files",
                     "open"},
      MissingFeature{"Vulkan", "DirectX, D3D, Metal, WebGPU, CUDA, OptiX, RTX, compute shader", "OpenGL",
                     "value/renderer/hardware"},
      MissingFeature{"shader editor", "GLSL, HLSL, edit the shader, custom shader", "listings that you change and run",
                     "study-listing"},
      MissingFeature{"other languages", "language, translation", "English texts", "glossary"},
  };
  return all;
}

}  // namespace ps::gui
