#pragma once
#include "image/colour_depth.h"
#include "image/texture_choices.h"
#include "options/triangle_tests.h"
#include "scene/normal_transform.h"

namespace ps {

enum class Renderer { ray_tracer, rasterizer, textbook };
enum class SamplePosition { centre, corner };
enum class SamplePattern { grid, jitter, random, halton, r2 };
enum class Projection { perspective, orthographic };
enum class ViewportFit { height, width, stretch };
enum class FieldOfViewSpan { edges, centres };
enum class Clipping { full, near_only, none };
enum class Visibility { depth_buffer, painter, draw_order };
enum class DepthValue { inverse_z, z, distance, ray_plane };
enum class DepthFormat { plain, unit_float, unorm };
enum class Coverage {
  edge_function,
  ray_test,
  bounding_box,
  barycentric,
  hoisted,
  scanline,
  hierarchical,
  tiled,
  micropolygon
};
enum class EdgeArithmetic { fixed, float32, float_stepped, int32 };
enum class FillRule { top_left, inclusive, exclusive };
enum class VertexSnapping { driver, cpu };
enum class Draw { filled, wireframe, points, outlined };
/// Are the insides of triangles drawn?
constexpr bool fills(Draw draw) { return draw == Draw::filled || draw == Draw::outlined; }
enum class CanvasFill { edges, rows };
enum class LineAlgorithm { general, y_of_x, x_of_y, interpolate, bresenham };
enum class Shading { phong, gouraud, flat };
enum class Normals { vertex, triangle };
enum class Highlight { phong, blinn_phong };
enum class Interpolation { perspective, affine };
enum class HardwareTexturing { shader, driver };
enum class MappedNormals { world_frame, inverse_transpose };
enum class Parallax { off, offset, limited, steep, occlusion };
enum class Patches { as_made, projected_error };
enum class LightPasses { one, many };
enum class Blending { off, draw_order, sorted };
enum class Environment { none, cube_map, room_map };
enum class EnvironmentObjects { all, fixed };
enum class Shadows { traced, none, map, stencil_depth_fail, stencil_depth_pass };
enum class ShadowRays { all, useful };
enum class SelfHit { offset, epsilon, normal_bump, exclusion };
enum class EpsilonUnit { ray_parameter, distance };
enum class Accelerator { bvh, none, bounding_spheres, box, octree, two_level, embree };
enum class SlabTest { robust, naive };
enum class SphereTest { robust, quadratic };
enum class Precision { float32, float64 };
enum class Simd { automatic, off, sse4, avx2, avx512 };
enum class Illumination { book, radiometric };
enum class TransparencyShare { fixed, fresnel };

/// From this on Settings::far is no limit.
inline constexpr double no_far_limit = 1e30;
/// In place of a light's index: no light is dark.
inline constexpr int all_lights = -1;

/// Every technique that can be chosen, as a plain value. Each member has one row in the option table
/// (options/option.h), which holds its key, label, range and help; the defaults are here and nowhere else.
struct Settings {
  Renderer renderer = Renderer::ray_tracer;
  int listing = 0;          ///< which listing the textbook renderer runs: 0 = automatic, then one by one
  int listing_bug = 0;      ///< which bug is planted in it: 0 = none, then one by one; no bug of another listing acts
  bool demo_slips = false;  ///< listings keep the bugs of the book's demo programs

  SamplePosition sample_position = SamplePosition::centre;
  int samples_per_pixel = 1;
  SamplePattern sample_pattern = SamplePattern::grid;
  bool adaptive_sampling = false;
  double adaptive_threshold = 0.1;  ///< difference of linear colours (1 = white at exposure 1) that asks for more
  int subsampling = 1;              ///< pixels between two traced ones, 1 = every pixel

  Projection projection = Projection::perspective;
  ViewportFit viewport_fit = ViewportFit::height;
  FieldOfViewSpan field_of_view_span = FieldOfViewSpan::edges;
  double near = 1;  ///< along the camera's forward axis, in units of projection_plane_d (the book's t_min = 1)
  double far = no_far_limit;    ///< same units; anything beyond is not seen
  bool camera_relative = true;  ///< an origin near the scene, or the camera, is subtracted before rounding to float

  Clipping clipping = Clipping::full;
  bool backface_culling = true;
  Visibility visibility = Visibility::depth_buffer;
  DepthValue depth_value = DepthValue::inverse_z;
  DepthFormat depth_format = DepthFormat::plain;
  int depth_bits = 24;  ///< of an integer depth buffer
  bool depth_reversed = false;
  bool early_depth = false;
  bool deferred_shading = false;
  LightPasses light_passes = LightPasses::one;
  Blending blending = Blending::off;
  int light_shown = all_lights;  ///< the index of the only light that shines, or all_lights
  int multisampling = 1;

  Coverage coverage = Coverage::edge_function;
  EdgeArithmetic edge_arithmetic = EdgeArithmetic::fixed;
  int subpixel_bits = 8;
  FillRule fill_rule = FillRule::top_left;
  VertexSnapping vertex_snapping = VertexSnapping::driver;
  Draw draw = Draw::filled;
  CanvasFill canvas_fill = CanvasFill::edges;  ///< of triangles and polygons on the canvas
  LineAlgorithm line_algorithm = LineAlgorithm::general;
  double tessellation = 0.5;  ///< largest chord error of a tessellated sphere, in pixels
  Patches patches = Patches::as_made;

  Shading shading = Shading::phong;
  Normals normals = Normals::vertex;
  bool renormalise = true;
  NormalTransform normal_transform = NormalTransform::inverse_transpose;
  bool lighting = true;
  Illumination illumination = Illumination::book;
  bool attenuation = true;
  bool diffuse = true;
  bool specular = true;
  Highlight highlight = Highlight::phong;
  Interpolation interpolation = Interpolation::perspective;

  bool textures = true;
  TextureFilter texture_filter = TextureFilter::trilinear;
  double mip_bias = 0;
  TextureWrap texture_wrap = TextureWrap::repeat;
  int anisotropy = 1;
  HardwareTexturing hardware_texturing = HardwareTexturing::shader;
  bool normal_mapping = true;
  MappedNormals mapped_normals = MappedNormals::world_frame;
  Parallax parallax = Parallax::off;
  int parallax_steps = 32;
  Environment environment = Environment::none;
  EnvironmentObjects environment_objects = EnvironmentObjects::all;
  int environment_size = 256;  ///< texels along an edge of a cube map

  Shadows shadows = Shadows::traced;
  SelfHit self_hit = SelfHit::offset;
  double shadow_epsilon = 0.001;
  double reflection_epsilon = 0.001;
  EpsilonUnit epsilon_unit = EpsilonUnit::ray_parameter;
  bool shadow_any_hit = true;
  ShadowRays shadow_rays = ShadowRays::all;
  bool shadow_cache = false;
  int shadow_samples = 1;  ///< shadow rays to a lamp
  SamplePattern shadow_pattern = SamplePattern::grid;
  int shadow_map_size = 1024;
  double shadow_bias = 0;
  double shadow_slope_bias = -1;  ///< below 0: what filter and slope need
  int shadow_filter = 1;
  int stencil_bits = 8;
  bool volume_caps = true;
  double volume_length = 0;  ///< world units; 0 = without end
  bool volume_depth_clamp = true;
  int reflection_depth = 3;
  double reflection_cutoff = 0;
  bool refraction = true;
  TransparencyShare transparency = TransparencyShare::fixed;

  Accelerator accelerator = Accelerator::bvh;
  int octree_leaf = 8;    ///< primitives that a cell may hold before it is cut
  int octree_depth = 10;  ///< how often a cell may be cut
  SlabTest slab_test = SlabTest::robust;
  TriangleTest triangle_test = TriangleTest::watertight;
  double triangle_epsilon = 0;
  SphereTest sphere_test = SphereTest::robust;
  Precision precision = Precision::float32;
  bool cache_constants = true;
  int threads = 0;  ///< 0 = one per processor
  Simd simd = Simd::automatic;

  ColourDepth colour_depth = ColourDepth::bits24;
  double exposure = 1;
  double gamma = 1;

  bool operator==(const Settings&) const = default;
};

}  // namespace ps
