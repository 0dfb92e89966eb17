#include "gui/frame/absent_features.h"

#include <array>

namespace ps::gui {

std::span<const AbsentFeature> absent_features() {
  static constexpr std::array all{
      AbsentFeature{"depth of field", "bokeh, aperture, focus, lens blur, thin lens", "the pinhole camera",
                    "lesson/cgfs_05_camera"},
      AbsentFeature{"ambient occlusion", "AO, SSAO, HBAO, contact shadows, crevice shading", "ambient light",
                    "lesson/cgfs_03_light"},
      AbsentFeature{"global illumination", "GI, path tracing, radiosity, photon mapping, indirect light, Monte Carlo",
                    "the Cornell box", "lesson/lab_cornell"},
      AbsentFeature{"motion blur", "shutter, moving objects", "several samples for each pixel",
                    "option/samples-per-pixel"},
      AbsentFeature{"caustics", "light through glass", "refraction", "lesson/cgfs_05_glass"},
      AbsentFeature{"fog", "volumetric, mist, smoke, participating media, god rays", "transparency and refraction",
                    "lesson/cgfs_05_glass"},
      AbsentFeature{"subsurface scattering", "SSS, skin, translucency", "light that is measured",
                    "lesson/cgpp_15_4_measured_light"},
      AbsentFeature{"microfacet model", "GGX, Cook-Torrance, metallic, roughness", "radiometric illumination",
                    "option/illumination"},
      AbsentFeature{"bloom", "glow, lens flare, vignette, post-processing, film grain", "exposure", "option/exposure"},
      AbsentFeature{"denoiser", "denoise, noise filter", "more samples for each pixel", "option/samples-per-pixel"},
      AbsentFeature{"temporal anti-aliasing", "TAA, FXAA, SMAA, DLSS, upscaling", "anti-aliasing by samples",
                    "technique/anti-aliasing/off"},
      AbsentFeature{"signed distance field", "SDF, ray marching, sphere tracing", "solids that are cut and joined",
                    "lesson/cgfs_05_solids"},
      AbsentFeature{"frame rate", "fps, frames per second, frame time", "the times of the two pictures",
                    "study-timings"},
      AbsentFeature{"histogram", "levels, distribution, waveform", "the difference and its largest pixels",
                    "study-pixels"},
      AbsentFeature{"video export", "record a video, gif, animation, keyframes", "pictures of the window",
                    "shot-window"},
      AbsentFeature{"glTF import", "gltf, glb, fbx, stl, ply, .blend, usd, 3ds, collada", "Wavefront OBJ files",
                    "open"},
      AbsentFeature{"Vulkan", "DirectX, D3D, Metal, WebGPU, CUDA, OptiX, RTX, compute shader", "OpenGL",
                    "value/renderer/hardware"},
      AbsentFeature{"shader editor", "GLSL, HLSL, edit the shader, custom shader", "listings that you change and run",
                    "study-listing"},
      AbsentFeature{"other languages", "language, translation", "English texts", "glossary"},
  };
  return all;
}

}  // namespace ps::gui
