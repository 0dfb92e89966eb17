#pragma once
#include <array>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hardware/context.h"
#include "hardware/shader_files.h"
#include "math/vec.h"
#include "record/shader_listing.h"

namespace ps::hardware {

/// A vertex and a fragment shader, compiled and linked. Belongs to the context that is current.
class Program {
 public:
  /// `captured`: outputs of the vertex shader that transform feedback keeps, one after the other. Throws InputError
  /// with the compiler's first message and the file and line that it is about.
  Program(std::string_view vertex_file, std::string_view fragment_file, Api api, std::string_view definitions,
          std::span<const char* const> captured = {});
  /// The same from texts that are held already.
  Program(ShaderFiles& files, std::string_view vertex_file, std::string_view fragment_file, Api api,
          std::string_view definitions, std::span<const char* const> captured = {});
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void use() const;
  /// The texts that the driver has compiled.
  ShaderPair texts() const;
  /// Gives a uniform of the program in use its value. One that the compiler left out, or the files do not have, is
  /// passed over.
  void set(std::string_view name, int value);
  void set(std::string_view name, float value);
  void set(std::string_view name, const Vec2f& value);
  void set(std::string_view name, const Vec3f& value);
  void set(std::string_view name, const Vec4f& value);
  void set(std::string_view name, const Vec4<int>& value);
  void set(std::string_view name, const Mat3d& value);
  /// Connects a uniform block with a binding point; false if the program has no such block.
  bool bind_block(std::string_view name, unsigned binding) const;

 private:
  void make(ShaderFiles& files, std::string_view vertex_file, std::string_view fragment_file, Api api,
            std::string_view definitions, std::span<const char* const> captured);
  int location(std::string_view name);

  std::array<std::vector<std::string>, 2> files_;  ///< by ShaderStage, as in ShaderText
  unsigned program_ = 0;
  std::map<std::string, int, std::less<>> locations_;
};

}  // namespace ps::hardware
