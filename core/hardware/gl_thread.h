#pragma once
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "hardware/channel_resolver.h"
#include "hardware/context.h"
#include "hardware/environment_maps.h"
#include "hardware/framebuffer.h"
#include "hardware/geometry_buffer.h"
#include "hardware/least_recent.h"
#include "hardware/mesh_buffers.h"
#include "hardware/program.h"
#include "hardware/sample_reader.h"
#include "hardware/shadow_maps.h"
#include "hardware/texture_store.h"

namespace ps::hardware {

/// The driver of this machine, or why there is none.
struct Availability {
  std::optional<Driver> driver;
  std::string reason;  ///< "no OpenGL: the library libEGL is not installed"; empty with a driver
};

/// The driver of this machine. The first call starts it.
const Availability& availability();
/// Whether availability() was called, and answers at once.
bool driver_is_known();

/// A program and what it is made from.
struct KeptProgram {
  std::string vertex_file, fragment_file, definitions;
  std::span<const char* const> captured;
  std::unique_ptr<Program> program;
  std::uint64_t used = 0;  ///< Workshop::clock of then
};

/// What is kept in the memory of the driver between pictures.
struct Workshop {
  explicit Workshop(const Context& made) : context(made) {}
  const Context& context;
  MeshStore meshes;
  TextureStore textures;
  MapStore maps;
  EnvironmentStore environment;
  ShaderFiles shaders;
  std::map<std::string, KeptProgram> programs;  ///< by their definitions
  std::uint64_t clock = 0;                      ///< counts uses of programs
  std::uint64_t last_picture = 0;               ///< its value before that
  std::unique_ptr<Framebuffer> target;          ///< of the last picture
  std::unique_ptr<GeometryBuffer> geometry;     ///< of the last picture with deferred shading
  std::unique_ptr<Framebuffer> story_picture;   ///< the same of the last story of a pixel
  std::unique_ptr<GeometryBuffer> story_geometry;
  std::unique_ptr<Framebuffer> story;           ///< what fragments report of themselves in it
  std::unique_ptr<SampleReader> sample_reader;  ///< this and the rest made when first needed
  std::unique_ptr<ChannelResolver> channel_resolver;
  unsigned vertex_array = 0, lights = 0;

  const Driver& driver() const { return context.driver(); }
  /// Between pictures this many are kept, or all of the last picture: a driver on the processor holds about a megabyte
  /// of machine code for each.
  static constexpr std::size_t most_programs = 32;
  /// Drops meshes and textures that no scene holds any more, and the programs that were not used for the longest time.
  /// Before a picture.
  void tidy();
  /// Drops the meshes and textures of all scenes. Before a picture.
  void forget_scenes() {
    meshes.clear();
    textures.clear();
  }
};

/// Carries out the task on the one thread that has a context of OpenGL, and returns when it has ended; what it throws
/// is thrown here. From any thread. Throws InputError with the reason where there is no driver.
void on_gl_thread(const std::function<void(Workshop&)>& task);

}  // namespace ps::hardware
