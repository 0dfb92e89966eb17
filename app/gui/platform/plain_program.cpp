#include "gui/platform/plain_program.h"

#include <epoxy/gl.h>

#include <array>

namespace ps::gui {
namespace {

constexpr const char* vertex_source = "uniform mat4 projection;\n"
                                      "in vec2 place;\n"
                                      "in vec2 corner;\n"
                                      "out vec2 uv;\n"
                                      "void main() { uv = corner; gl_Position = projection * vec4(place, 0, 1); }\n";
constexpr const char* plain_source = "uniform sampler2D picture;\n"
                                     "in vec2 uv;\n"
                                     "out vec4 colour;\n"
                                     "void main() { colour = texture(picture, uv); }\n";
// The filter mixes two texels by the place between their centres. Half a pixel of the window on both sides of their
// edge becomes that way; beyond it the place is a centre, a little behind it so that rounding reaches no other texel.
constexpr const char* even_source = "uniform sampler2D picture;\n"
                                    "in vec2 uv;\n"
                                    "out vec4 colour;\n"
                                    "void main() {\n"
                                    "  vec2 size = vec2(textureSize(picture, 0)), place = uv * size;\n"
                                    "  vec2 edge = floor(place + 0.5);\n"
                                    "  place = edge + clamp((place - edge) / fwidth(place), -0.5, 0.5) + 0.0005;\n"
                                    "  colour = texture(picture, place / size);\n"
                                    "}\n";

GLuint compiled(GLenum kind, const char* source) {
  const GLuint shader = glCreateShader(kind);
  const std::array sources{epoxy_gl_version() >= 32 ? "#version 150\n" : "#version 130\n", source};
  glShaderSource(shader, static_cast<GLsizei>(sources.size()), sources.data(), nullptr);
  glCompileShader(shader);
  return shader;
}

/// A program that draws textures with the vertices of Dear ImGui's back end, where these are read by `theirs`; 0 if it
/// cannot be made.
GLuint program_of(const char* fragment_source, GLuint theirs) {
  const GLint place = glGetAttribLocation(theirs, "Position"), corner = glGetAttribLocation(theirs, "UV");
  if (place < 0 || corner < 0) return 0;
  const GLuint program = glCreateProgram();
  const std::array shaders{compiled(GL_VERTEX_SHADER, vertex_source), compiled(GL_FRAGMENT_SHADER, fragment_source)};
  for (const GLuint shader : shaders) glAttachShader(program, shader);
  glBindAttribLocation(program, static_cast<GLuint>(place), "place");
  glBindAttribLocation(program, static_cast<GLuint>(corner), "corner");
  glLinkProgram(program);
  for (const GLuint shader : shaders) glDeleteShader(shader);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked) return program;
  glDeleteProgram(program);
  return 0;
}

/// The program that is in use: that of Dear ImGui's back end.
GLuint program_in_use() {
  GLint number = 0;
  glGetIntegerv(GL_CURRENT_PROGRAM, &number);
  return static_cast<GLuint>(number);
}

/// Draws with this program what comes next.
void use(GLuint program) {
  if (program == 0) return;
  const ImDrawData& data = *ImGui::GetDrawData();
  const float left = data.DisplayPos.x, right = left + data.DisplaySize.x, top = data.DisplayPos.y,
              bottom = top + data.DisplaySize.y;
  const std::array<float, 16> projection{2 / (right - left),
                                         0,
                                         0,
                                         0,
                                         0,
                                         2 / (top - bottom),
                                         0,
                                         0,
                                         0,
                                         0,
                                         -1,
                                         0,
                                         (right + left) / (left - right),
                                         (top + bottom) / (bottom - top),
                                         0,
                                         1};
  glUseProgram(program);
  glUniform1i(glGetUniformLocation(program, "picture"), 0);
  glUniformMatrix4fv(glGetUniformLocation(program, "projection"), 1, GL_FALSE, projection.data());
  glDisable(GL_BLEND);
}

}  // namespace

void begin_plain(const ImDrawList* /*list*/, const ImDrawCmd* /*command*/) {
  static const GLuint program = program_of(plain_source, program_in_use());
  use(program);
}

void begin_even(const ImDrawList* /*list*/, const ImDrawCmd* /*command*/) {
  static const GLuint program = program_of(even_source, program_in_use());
  use(program);
}

}  // namespace ps::gui
