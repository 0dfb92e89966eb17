#include "bench/llvmpipe/gl_context.h"

#include <fmt/core.h>

#include <cstdlib>
#include <vector>

#include "base/check.h"

namespace ps::bench {

GlContext& GlContext::get() {
  static GlContext context;
  return context;
}

GlContext::GlContext() {
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  setenv("GALLIUM_DRIVER", "llvmpipe", 1);
  setenv("LP_NUM_THREADS", "2", 1);
  display_ = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API))
    throw InputError("EGL without a surface cannot be started; on Debian install libegl1 and libgl1-mesa-dri");
  const EGLint attributes[] = {
      EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  if (context_ == EGL_NO_CONTEXT || !eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
    throw InputError("OpenGL 3.3 without a surface cannot be had");
  renderer_ = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  if (renderer_.find("llvmpipe") == std::string::npos)
    throw InputError(fmt::format("OpenGL is {}, not Mesa's llvmpipe", renderer_));
}

GlContext::~GlContext() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  eglTerminate(display_);
}

GlTarget::GlTarget(int width, int height) : width_(width), height_(height) {
  GlContext::get();
  glGenFramebuffers(1, &framebuffer_);
  glGenRenderbuffers(1, &colour_);
  glGenRenderbuffers(1, &depth_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glBindRenderbuffer(GL_RENDERBUFFER, colour_);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
  glBindRenderbuffer(GL_RENDERBUFFER, depth_);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw InputError("OpenGL has no such framebuffer");
}

GlTarget::~GlTarget() {
  glDeleteFramebuffers(1, &framebuffer_);
  glDeleteRenderbuffers(1, &colour_);
  glDeleteRenderbuffers(1, &depth_);
}

void GlTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(0, 0, width_, height_);
}

Image<Rgb8> GlTarget::read() const {
  bind();
  Image<Rgb8> bottom_up(width_, height_), picture(width_, height_);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, bottom_up.pixels().data());
  check_gl("reading the picture");
  for (int y = 0; y < height_; ++y) {
    const auto row = bottom_up.row(height_ - 1 - y);
    std::copy(row.begin(), row.end(), picture.row(y).begin());
  }
  return picture;
}

GLuint make_program(const char* vertex_source, const char* fragment_source) {
  const GLuint program = glCreateProgram();
  const auto add = [&](GLenum kind, const char* source) {
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    std::vector<char> log(4096);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    if (!compiled) throw InputError(fmt::format("a shader does not compile: {}", log.data()));
    glAttachShader(program, shader);
    glDeleteShader(shader);
  };
  add(GL_VERTEX_SHADER, vertex_source);
  add(GL_FRAGMENT_SHADER, fragment_source);
  glLinkProgram(program);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (!linked) throw InputError("the shaders do not fit together");
  return program;
}

void check_gl(const char* what) {
  if (const GLenum error = glGetError(); error != GL_NO_ERROR)
    throw InputError(fmt::format("OpenGL error {:#x} at {}", error, what));
}

}  // namespace ps::bench
