#include "hardware/uniform_values.h"

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace ps::hardware {
namespace {

constexpr int most_elements = 8;  // of an array that are shown

struct ActiveUniform {
  std::string name;
  GLint elements = 0;
  GLenum type = 0;
  GLuint index = 0;
};

ActiveUniform active_uniform(GLuint program, GLuint index) {
  ActiveUniform uniform;
  std::array<char, 128> name{};
  glGetActiveUniform(program, index, static_cast<GLsizei>(name.size()), nullptr, &uniform.elements, &uniform.type,
                     name.data());
  uniform.name = name.data();
  uniform.name = uniform.name.substr(0, uniform.name.find('['));
  uniform.index = index;
  return uniform;
}

template <class Number>
std::string list_of(const Number* values, int count) {
  std::vector<std::string> texts;
  texts.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) texts.push_back(fmt::format("{:.6g}", static_cast<double>(values[i])));
  return fmt::format("{}", fmt::join(texts, ", "));
}

/// Rows one after the other, as a matrix is written on paper.
std::string matrix_text(const std::array<float, 16>& columns) {
  std::string text;
  for (std::size_t row = 0; row < 3; ++row) {
    const std::array<float, 3> values{columns[row], columns[3 + row], columns[6 + row]};
    text += fmt::format("{}({})", row == 0 ? "" : " ", list_of(values.data(), 3));
  }
  return text;
}

std::string texture_text(GLuint program, GLint location, GLenum target) {
  GLint unit = 0, width = 0, height = 0, depth = 0;
  glGetUniformiv(program, location, &unit);
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glGetTexLevelParameteriv(target, 0, GL_TEXTURE_WIDTH, &width);
  glGetTexLevelParameteriv(target, 0, GL_TEXTURE_HEIGHT, &height);
  glGetTexLevelParameteriv(target, 0, GL_TEXTURE_DEPTH, &depth);
  if (target == GL_TEXTURE_2D_ARRAY)
    return fmt::format("unit {}: {} layers of {} x {} texels", unit, depth, width, height);
  return fmt::format("unit {}: {} x {} texels", unit, width, height);
}

/// How many numbers a value of the type has, if they are floats; 0 if they are not.
int floats_of(GLenum type) {
  switch (type) {
  case GL_FLOAT:
    return 1;
  case GL_FLOAT_VEC2:
    return 2;
  case GL_FLOAT_VEC3:
    return 3;
  case GL_FLOAT_VEC4:
    return 4;
  default:  // OpenGL's own numbers, no enum of ours
    return 0;
  }
}

std::string value_of(GLuint program, const ActiveUniform& uniform, GLint location) {
  std::array<float, 16> floats{};
  std::array<GLint, 4> integers{};
  if (const int count = floats_of(uniform.type); count > 0) {
    glGetUniformfv(program, location, floats.data());
    return list_of(floats.data(), count);
  }
  if (uniform.type == GL_FLOAT_MAT3) {
    glGetUniformfv(program, location, floats.data());
    return matrix_text(floats);
  }
  if (uniform.type == GL_SAMPLER_2D) return texture_text(program, location, GL_TEXTURE_2D);
  if (uniform.type == GL_SAMPLER_2D_ARRAY) return texture_text(program, location, GL_TEXTURE_2D_ARRAY);
  glGetUniformiv(program, location, integers.data());
  return list_of(integers.data(), uniform.type == GL_INT_VEC4 ? 4 : 1);
}

/// Of an array of vec4, the only type that our blocks have.
std::optional<std::string> value_in_block(GLuint program, const ActiveUniform& uniform) {
  const auto about = [&](GLenum what) {
    GLint value = 0;
    glGetActiveUniformsiv(program, 1, &uniform.index, what, &value);
    return value;
  };
  const GLint block = about(GL_UNIFORM_BLOCK_INDEX), offset = about(GL_UNIFORM_OFFSET);
  if (block < 0 || uniform.type != GL_FLOAT_VEC4) return {};
  GLint binding = 0, buffer = 0;
  glGetActiveUniformBlockiv(program, static_cast<GLuint>(block), GL_UNIFORM_BLOCK_BINDING, &binding);
  glGetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, static_cast<GLuint>(binding), &buffer);
  const int shown = std::min(uniform.elements, most_elements);
  std::vector<float> values(static_cast<std::size_t>(4 * shown));
  GLint size = 0;
  glBindBuffer(GL_COPY_READ_BUFFER, static_cast<GLuint>(buffer));
  if (buffer != 0) glGetBufferParameteriv(GL_COPY_READ_BUFFER, GL_BUFFER_SIZE, &size);
  if (offset + static_cast<GLint>(values.size() * sizeof(float)) > size) return "no buffer holds it";
  glGetBufferSubData(GL_COPY_READ_BUFFER, offset, static_cast<GLsizeiptr>(values.size() * sizeof(float)),
                     values.data());
  std::string text;
  for (int i = 0; i < shown; ++i)
    text += fmt::format("{}[{}] = ({})", i == 0 ? "" : ", ", i, list_of(values.data() + 4 * i, 4));
  return text + (shown < uniform.elements ? fmt::format(", and {} more", uniform.elements - shown) : "");
}

}  // namespace

UniformTexts uniform_values(const Program& program) {
  UniformTexts texts;
  GLint count = 0;
  glGetProgramiv(program.id(), GL_ACTIVE_UNIFORMS, &count);
  for (GLint i = 0; i < count; ++i) {
    const ActiveUniform uniform = active_uniform(program.id(), static_cast<GLuint>(i));
    const GLint location = glGetUniformLocation(program.id(), uniform.name.c_str());
    if (location >= 0)
      texts[uniform.name] = value_of(program.id(), uniform, location);
    else if (const auto text = value_in_block(program.id(), uniform))
      texts[uniform.name] = *text;
  }
  check_gl("reading the values of uniforms");
  return texts;
}

}  // namespace ps::hardware
