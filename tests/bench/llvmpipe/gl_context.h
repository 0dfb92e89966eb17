#pragma once
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <string>

#include "image/image.h"

namespace ps::bench {

/// OpenGL without a window (EGL, surfaceless), in Mesa's software renderer with two threads. One per process, since
/// Mesa reads its settings once.
class GlContext {
 public:
  /// The context, made current; throws InputError if there is no such OpenGL here.
  static GlContext& get();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// As OpenGL names itself: "llvmpipe (LLVM 15.0.6, 256 bits)".
  const std::string& renderer() const { return renderer_; }

 private:
  GlContext();
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
  std::string renderer_;
};

/// A picture to draw into: RGBA8 with 24 bits of depth.
class GlTarget {
 public:
  GlTarget(int width, int height);
  ~GlTarget();
  GlTarget(const GlTarget&) = delete;
  GlTarget& operator=(const GlTarget&) = delete;

  void bind() const;
  /// Top row first, as our pictures are.
  Image<Rgb8> read() const;

 private:
  int width_, height_;
  GLuint framebuffer_ = 0, colour_ = 0, depth_ = 0;
};

/// A program from its two sources; throws InputError with the compiler's words.
GLuint make_program(const char* vertex_source, const char* fragment_source);

/// Throws InputError if an OpenGL call before has failed.
void check_gl(const char* what);

}  // namespace ps::bench
