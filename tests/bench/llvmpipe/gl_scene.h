#pragma once
#include "bench/llvmpipe/gl_context.h"
#include "frame/view.h"
#include "options/settings.h"
#include "scene/scene.h"

namespace ps::bench {

/// A scene of one untransformed mesh with one material, drawn by OpenGL as our rasterizer does: per-pixel book
/// lighting, or the surface colour alone with `lighting` off; depth test; culling, texture and filter as set.
class GlScene {
 public:
  GlScene(const Scene& scene, const View& view, const Settings& settings);
  ~GlScene();
  GlScene(const GlScene&) = delete;
  GlScene& operator=(const GlScene&) = delete;

  /// Clears, draws, and waits until all is done.
  void draw() const;
  Image<Rgb8> read() const { return target_.read(); }

 private:
  void upload_mesh(const Mesh& mesh);
  void upload_texture(const Texture& texture);
  void set_uniforms(const Scene& scene, const View& view, const Mesh& mesh) const;

  GlTarget target_;
  Settings settings_;
  Vec3f background_;
  GLuint program_ = 0, vertex_array_ = 0, vertices_ = 0, indices_ = 0, texture_ = 0;
  GLsizei index_count_ = 0;
};

}  // namespace ps::bench
