#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "hardware/canvas_shapes.h"
#include "hardware/draw_passes.h"
#include "hardware/gl_thread.h"
#include "hardware/picture_plan.h"
#include "hardware/volume_buffers.h"

namespace ps::hardware {

/// Triangles of one surface that follow each other in drawing order.
struct DrawRun {
  std::size_t object = 0;            ///< index into PicturePlan::objects
  std::size_t surface = 0;           ///< index into Surfaces::list
  std::size_t first = 0, count = 0;  ///< triangles of the mesh, or of the list of sorted triangles
};

/// Compiles it from these texts. On the thread of OpenGL only; throws as Program does.
std::unique_ptr<Program> make_program(const KeptProgram& kept, ShaderFiles& files, Api api);

/// Draws one picture. On the thread of OpenGL only.
class PictureDrawer {
 public:
  PictureDrawer(const PicturePlan& plan, Workshop& shop);
  ~PictureDrawer();
  PictureDrawer(const PictureDrawer&) = delete;
  PictureDrawer& operator=(const PictureDrawer&) = delete;

  /// Gives the driver all that it needs and does not have yet: meshes, textures, shaders, the target.
  void upload();
  /// Draws everything; what it drew is complete when it returns.
  void draw();
  /// Samples that were written, as the driver counts them.
  std::uint64_t samples_written() const { return samples_written_; }
  std::uint64_t triangles() const { return triangles_; }

 protected:
  void require_room_for_meshes();
  void upload_lights();
  void upload_object(std::size_t object);
  void snap_vertices(std::size_t object);
  void make_runs();
  void make_sorted_runs();
  void bind_streams(std::size_t object);
  std::vector<Stream> streams_of(std::size_t object) const;
  void upload_surface_table();
  void upload_volumes();
  void set_state();
  void set_pass(const DrawPass& pass);
  unsigned stencil_mask() const;
  void set_light(Program& program, const DrawPass& pass);
  void set_facing(std::size_t object);
  void draw_pass(const DrawPass& pass);
  /// Gives the program all that it needs to draw triangles of the run in this pass.
  void prepare_run(Program& program, const DrawRun& run, const DrawPass& pass);
  void draw_triangles(const DrawRun& run) const;
  void draw_runs(const DrawPass& pass);
  void draw_whole_picture(Program& program, const DrawPass& pass);
  void resolve_channels();
  Program& deferred_program();
  /// `draw_one` has each shape drawn in its turn.
  void draw_canvas(const std::function<void(const CanvasDraw&)>& draw_one);
  static void draw_shape(const CanvasDraw& draw);
  void count_volumes(const std::vector<VolumeBuffers>& volumes);
  /// The state in which the faces of volumes are drawn, but for what they do to the stencil buffer.
  void set_volume_state(Program& program);
  Program& volume_program();
  void set_object(Program& program, std::size_t object);
  void set_view(Program& program);
  void set_depth(Program& program);
  void set_surface(Program& program, const raster::Surface<float>& surface);
  float surface_error(const raster::Surface<float>& surface) const;
  void set_shadow_maps(Program& program);
  void set_environment(Program& program);
  void set_geometry(Program& program);
  Program& program_of(const raster::Surface<float>& surface);
  Program& program_of(const char* vertex_file, const char* fragment_file, const std::string& definitions,
                      std::span<const char* const> captured = {});
  FramebufferShape framebuffer_shape() const;

  const PicturePlan& plan_;
  Workshop& shop_;
  bool keeps_depth_;  ///< the driver interpolates it
  std::vector<DrawRun> runs_;
  std::vector<Program*> programs_;               ///< of each surface
  std::vector<std::vector<Vec3f>> places_;       ///< of each object's vertices, as the processor rounded them
  std::vector<unsigned> snapped_;                ///< buffers of positions that the processor rounded, of each object
  unsigned sorted_ = 0;                          ///< indices of the vertices, where triangles are sorted
  std::vector<std::uint32_t> sorted_triangles_;  ///< numbers of the triangles in their meshes, where they are sorted
  unsigned surface_table_ = 0;
  std::vector<std::vector<VolumeBuffers>> volumes_;  ///< by light
  unsigned query_ = 0;
  std::uint64_t samples_written_ = 0, triangles_ = 0;
};

}  // namespace ps::hardware
