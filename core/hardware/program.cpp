#include "hardware/program.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <utility>

#include "base/check.h"
#include "hardware/shader_text.h"

namespace ps::hardware {
namespace {

/// A shader object; the program keeps what it needs of it.
class Shader {
 public:
  Shader(GLenum kind, const ShaderText& shader) : Shader(kind, shader.text) {
    if (compiles()) return;
    const Shader numbered(kind, with_numbered_files(shader));
    throw InputError(fmt::format("a shader does not compile: {}", compiler_words(shader, numbered.log())));
  }
  ~Shader() { glDeleteShader(id_); }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;
  GLuint id() const { return id_; }

 private:
  Shader(GLenum kind, const std::string& text) : id_(glCreateShader(kind)) {
    const char* all = text.c_str();
    glShaderSource(id_, 1, &all, nullptr);
    glCompileShader(id_);
  }
  bool compiles() const {
    GLint compiled = 0;
    glGetShaderiv(id_, GL_COMPILE_STATUS, &compiled);
    return compiled != 0;
  }
  std::string log() const {
    std::vector<char> words(4096);
    glGetShaderInfoLog(id_, static_cast<GLsizei>(words.size()), nullptr, words.data());
    return words.data();
  }

  GLuint id_;
};

}  // namespace

Program::Program(std::string_view vertex_file, std::string_view fragment_file, Api api, std::string_view definitions,
                 std::span<const char* const> captured) {
  ShaderFiles files;
  make(files, vertex_file, fragment_file, api, definitions, captured);
}

Program::Program(ShaderFiles& files, std::string_view vertex_file, std::string_view fragment_file, Api api,
                 std::string_view definitions, std::span<const char* const> captured) {
  make(files, vertex_file, fragment_file, api, definitions, captured);
}

void Program::make(ShaderFiles& files, std::string_view vertex_file, std::string_view fragment_file, Api api,
                   std::string_view definitions, std::span<const char* const> captured) {
  ShaderText vertex_text = shader_text(files, vertex_file, ShaderStage::vertex, api, definitions);
  ShaderText fragment_text = shader_text(files, fragment_file, ShaderStage::fragment, api, definitions);
  const Shader vertex(GL_VERTEX_SHADER, vertex_text);
  const Shader fragment(GL_FRAGMENT_SHADER, fragment_text);
  files_ = {std::move(vertex_text.files), std::move(fragment_text.files)};
  program_ = glCreateProgram();
  glAttachShader(program_, vertex.id());
  glAttachShader(program_, fragment.id());
  if (!captured.empty())
    glTransformFeedbackVaryings(program_, static_cast<GLsizei>(captured.size()), captured.data(),
                                GL_INTERLEAVED_ATTRIBS);
  glLinkProgram(program_);
  GLint linked = 0;
  glGetProgramiv(program_, GL_LINK_STATUS, &linked);
  if (linked) return;
  std::vector<char> log(4096);
  glGetProgramInfoLog(program_, static_cast<GLsizei>(log.size()), nullptr, log.data());
  glDeleteProgram(program_);
  throw InputError(
      fmt::format("the shaders {} and {} do not fit together: {}", vertex_file, fragment_file, log.data()));
}

Program::~Program() { glDeleteProgram(program_); }

void Program::use() const { glUseProgram(program_); }

ShaderPair Program::texts() const {
  ShaderPair texts;
  std::array<GLuint, 2> shaders{};
  glGetAttachedShaders(program_, 2, nullptr, shaders.data());
  for (const GLuint shader : shaders) {
    GLint kind = 0, length = 0;
    glGetShaderiv(shader, GL_SHADER_TYPE, &kind);
    glGetShaderiv(shader, GL_SHADER_SOURCE_LENGTH, &length);
    std::vector<char> source(static_cast<std::size_t>(length) + 1);  // with a zero at its end
    glGetShaderSource(shader, length, nullptr, source.data());
    const auto stage = static_cast<std::size_t>(kind == GL_VERTEX_SHADER ? ShaderStage::vertex : ShaderStage::fragment);
    texts[stage] = {source.data(), files_[stage]};
  }
  return texts;
}

int Program::location(std::string_view name) {
  const auto found = locations_.find(name);
  if (found != locations_.end()) return found->second;
  const std::string text(name);
  return locations_[text] = glGetUniformLocation(program_, text.c_str());
}

void Program::set(std::string_view name, int value) { glUniform1i(location(name), value); }
void Program::set(std::string_view name, float value) { glUniform1f(location(name), value); }
void Program::set(std::string_view name, const Vec2f& value) { glUniform2f(location(name), value.x, value.y); }
void Program::set(std::string_view name, const Vec3f& value) { glUniform3f(location(name), value.x, value.y, value.z); }
void Program::set(std::string_view name, const Vec4f& value) {
  glUniform4f(location(name), value.x, value.y, value.z, value.w);
}
void Program::set(std::string_view name, const Vec4<int>& value) {
  glUniform4i(location(name), value.x, value.y, value.z, value.w);
}
void Program::set(std::string_view name, const Mat3d& value) {
  std::array<float, 9> columns;
  std::size_t next = 0;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) columns[next++] = static_cast<float>(value[c][r]);
  glUniformMatrix3fv(location(name), 1, GL_FALSE, columns.data());
}

bool Program::bind_block(std::string_view name, unsigned binding) const {
  const GLuint index = glGetUniformBlockIndex(program_, std::string(name).c_str());
  if (index == GL_INVALID_INDEX) return false;
  glUniformBlockBinding(program_, index, binding);
  return true;
}

}  // namespace ps::hardware
