#include "hardware/context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <functional>
#include <optional>
#include <vector>

#include "base/available_memory.h"
#include "base/check.h"

namespace ps::hardware {

// A function of EGL or OpenGL that is missing makes libepoxy end the program, so each is asked for before it is called.

struct Context::Handles {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  EGLSurface surface = EGL_NO_SURFACE;  ///< only where contexts cannot do without
};

namespace {

struct Display {
  std::string platform;
  EGLDisplay display = EGL_NO_DISPLAY;
};

bool client_has(const char* extension) { return epoxy_has_egl_extension(EGL_NO_DISPLAY, extension); }

std::string_view name_of(Api api) { return api == Api::desktop ? "OpenGL 3.3" : "OpenGL ES 3.0"; }

/// Ways to a display, in the order in which they are tried. Each is opened only when its turn comes.
std::vector<std::function<Display()>> ways() {
  std::vector<std::function<Display()>> all;
  const bool platforms = client_has("EGL_EXT_platform_base");
  const bool enumerates = client_has("EGL_EXT_device_base") || client_has("EGL_EXT_device_enumeration");
  if (platforms && enumerates && client_has("EGL_EXT_platform_device")) {
    constexpr EGLint most = 16;
    std::vector<EGLDeviceEXT> devices(most);
    EGLint count = 0;
    if (!eglQueryDevicesEXT(most, devices.data(), &count)) count = 0;
    for (EGLint i = 0; i < count; ++i)
      all.push_back([device = devices[static_cast<std::size_t>(i)]] {
        return Display{"EGL device", eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr)};
      });
  }
  if (platforms && client_has("EGL_MESA_platform_surfaceless"))
    all.push_back([] {
      return Display{"surfaceless",
                     eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)};
    });
  all.push_back([] { return Display{"default display", eglGetDisplay(EGL_DEFAULT_DISPLAY)}; });
  return all;
}

std::string text_of(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text ? reinterpret_cast<const char*>(text) : "";
}

int number_of(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

EGLConfig choose_config(EGLDisplay display, Api api, bool needs_surface) {
  const EGLint attributes[] = {EGL_RENDERABLE_TYPE, api == Api::desktop ? EGL_OPENGL_BIT : EGL_OPENGL_ES3_BIT,
                               EGL_SURFACE_TYPE, needs_surface ? EGL_PBUFFER_BIT : EGL_DONT_CARE, EGL_NONE};
  EGLConfig config = EGL_NO_CONFIG_KHR;
  EGLint count = 0;
  if (!eglChooseConfig(display, attributes, &config, 1, &count) || count == 0) return EGL_NO_CONFIG_KHR;
  return config;
}

struct EglVersion {
  EGLint major = 0, minor = 0;
};

/// nullopt: no driver starts there.
std::optional<EglVersion> start_driver(const Display& way) {
  EglVersion version;
  if (way.display == EGL_NO_DISPLAY || !eglInitialize(way.display, &version.major, &version.minor)) return {};
  return version;
}

/// Empty if all went well, otherwise the reason.
std::string open_context(const Display& way, const EglVersion& version, Api api, EGLContext& context,
                         EGLSurface& surface) {
  const auto [major, minor] = version;
  if (major == 1 && minor < 4) return fmt::format("EGL is {}.{}, not 1.4", major, minor);
  const auto display_has = [&](const char* name) { return epoxy_has_egl_extension(way.display, name); };
  const bool versions = (major == 1 && minor >= 5) || major > 1 || display_has("EGL_KHR_create_context");
  if (!versions) return "EGL cannot ask for a version of OpenGL";
  if (!eglBindAPI(api == Api::desktop ? EGL_OPENGL_API : EGL_OPENGL_ES_API))
    return fmt::format("the driver does not offer {}", name_of(api));
  const bool no_surface = display_has("EGL_KHR_surfaceless_context");
  const bool no_config = display_has("EGL_KHR_no_config_context") || display_has("EGL_MESA_configless_context");
  EGLConfig config = EGL_NO_CONFIG_KHR;
  if (!no_config || !no_surface) config = choose_config(way.display, api, !no_surface);
  if (!no_config && config == EGL_NO_CONFIG_KHR) return "no configuration without a window";
  std::vector<EGLint> asked{EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, api == Api::desktop ? 3 : 0};
  if (api == Api::desktop)
    asked.insert(asked.end(), {EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT});
  asked.push_back(EGL_NONE);
  context = eglCreateContext(way.display, config, EGL_NO_CONTEXT, asked.data());
  if (context == EGL_NO_CONTEXT) return fmt::format("the driver does not offer {}", name_of(api));
  if (!no_surface) {
    const EGLint size[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
    surface = eglCreatePbufferSurface(way.display, config, size);
  }
  if (!eglMakeCurrent(way.display, surface, surface, context)) return "its context cannot be used without a window";
  return {};
}

/// Of pictures of 32-bit floats.
std::vector<int> sample_counts() {
  if (epoxy_gl_version() >= (epoxy_is_desktop_gl() ? 42 : 30) ||
      epoxy_has_gl_extension("GL_ARB_internalformat_query")) {
    GLint count = 0;
    glGetInternalformativ(GL_RENDERBUFFER, GL_RGBA32F, GL_NUM_SAMPLE_COUNTS, 1, &count);
    std::vector<int> counts(static_cast<std::size_t>(count));
    if (count > 0) glGetInternalformativ(GL_RENDERBUFFER, GL_RGBA32F, GL_SAMPLES, count, counts.data());
    return counts;
  }
  std::vector<int> counts;
  for (int samples = 2; samples <= number_of(GL_MAX_SAMPLES); samples *= 2) counts.push_back(samples);
  return counts;
}

Driver ask_driver(const std::string& platform, Api api) {
  Driver driver;
  driver.renderer = text_of(GL_RENDERER);
  driver.vendor = text_of(GL_VENDOR);
  driver.version = text_of(GL_VERSION);
  driver.platform = platform;
  driver.subpixel_bits = number_of(GL_SUBPIXEL_BITS);
  driver.max_size = std::min(number_of(GL_MAX_TEXTURE_SIZE), number_of(GL_MAX_RENDERBUFFER_SIZE));
  driver.samples = sample_counts();
  driver.max_block_bytes = number_of(GL_MAX_UNIFORM_BLOCK_SIZE);
  if (api == Api::desktop)
    driver.clip_control = epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_ARB_clip_control");
  return driver;
}

}  // namespace

Context::Context(Api api) : api_(api), handles_(std::make_unique<Handles>()) {
  if (!epoxy_has_egl()) throw InputError("no OpenGL: the library libEGL is not installed");
  std::string reason;  // of the last driver that started
  for (const auto& open : ways()) {
    const Display way = open();
    const std::optional<EglVersion> version = start_driver(way);
    if (!version) continue;
    EGLContext context = EGL_NO_CONTEXT;
    EGLSurface surface = EGL_NO_SURFACE;
    const std::string failure = open_context(way, *version, api, context, surface);
    if (failure.empty()) {
      *handles_ = {way.display, context, surface};
      driver_ = ask_driver(way.platform, api);
      return;
    }
    reason = failure;
    if (context != EGL_NO_CONTEXT) eglDestroyContext(way.display, context);
  }
  constexpr std::uint64_t plenty = 1u << 30;
  if (reason.empty()) {
    reason = "no driver";
    if (const auto left = available_memory(); left && *left < plenty)
      reason += fmt::format(" starts in the {} MB of memory that are left", *left >> 20);
  }
  throw InputError(fmt::format("no OpenGL: {}", reason));
}

Context::~Context() {
  if (handles_->context == EGL_NO_CONTEXT) return;
  eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(handles_->display, handles_->context);
  if (handles_->surface != EGL_NO_SURFACE) eglDestroySurface(handles_->display, handles_->surface);
}

void Context::make_current() const {
  eglBindAPI(api_ == Api::desktop ? EGL_OPENGL_API : EGL_OPENGL_ES_API);
  if (!eglMakeCurrent(handles_->display, handles_->surface, handles_->surface, handles_->context)) throw ContextLost();
}

void Context::lose() const {
  eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglTerminate(handles_->display);
}

void forget_errors() {
  constexpr int most = 16;  // a lost context reports its loss for ever
  for (int i = 0; i < most && glGetError() != GL_NO_ERROR; ++i) continue;
}

void check_gl(const char* what) {
  const GLenum error = glGetError();
  if (error == GL_CONTEXT_LOST) throw ContextLost();
  if (error != GL_NO_ERROR)
    throw InputError(error == GL_OUT_OF_MEMORY
                         ? fmt::format("the graphics driver has no memory left at {}", what)
                         : fmt::format("the graphics driver reports error {:#x} at {}", error, what));
}

}  // namespace ps::hardware
