#include "hardware/shader_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <sstream>

#include "base/check.h"
#include "base/number_text.h"

namespace ps::hardware {
namespace {

constexpr std::string_view desktop_head = "#version 330 core\n";
constexpr std::string_view embedded_head =
    "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
    "precision highp sampler2DArray;\n";

/// Numbers that files compare their definitions with, after the enums of options/settings.h and story_pages.h.
constexpr std::string_view names =
    "#define UNLIT 0\n#define PHONG 1\n#define GOURAUD 2\n#define FLAT 3\n"
    "#define AMBIENT_LIGHT 0\n#define POINT_LIGHT 1\n#define DIRECTIONAL_LIGHT 2\n"
    "#define FILTER_TRILINEAR 0\n#define FILTER_MIPMAP 1\n#define FILTER_BILINEAR 2\n#define FILTER_NEAREST 3\n"
    "#define WRAP_REPEAT 0\n#define WRAP_CLAMP 1\n#define WRAP_MIRROR 2\n"
    "#define DEPTH_INVERSE_Z 0\n#define DEPTH_Z 1\n#define DEPTH_DISTANCE 2\n"
    "#define DEPTH_PLAIN 0\n#define DEPTH_UNIT_FLOAT 1\n#define DEPTH_UNORM 2\n"
    "#define PARALLAX_OFF 0\n#define PARALLAX_OFFSET 1\n#define PARALLAX_LIMITED 2\n#define PARALLAX_STEEP 3\n"
    "#define PARALLAX_OCCLUSION 4\n"
    "#define UPRIGHT_IN_WORLD 0\n#define BY_INVERSE_TRANSPOSE 1\n"
    "#define PAGE_SEEN 0\n#define PAGE_WEIGHTS 1\n#define PAGE_SCREEN 2\n#define PAGE_NORMAL 3\n"
    "#define PAGE_UNMAPPED 4\n#define PAGE_UV 5\n#define PAGE_COLOUR 6\n#define PAGE_TEXEL 7\n"
    "#define PAGE_STORED 8\n#define PAGE_TANGENT 9\n#define PAGE_BITANGENT 10\n#define PAGE_RELIEF 11\n"
    "#define PAGE_LIGHT 12\n#define PAGE_EXTRA 13\n#define PAGE_SHADED 14\n#define PAGE_TO_LIGHT 15\n"
    "#define PAGE_TERMS 16\n#define PAGE_MIRRORED 17\n#define PAGE_MIRROR_PLACE 18\n"
    "#define PAGE_MIRROR_DIRECTION 19\n#define PAGE_UNMIRRORED 20\n";

/// A name for the preprocessor: "cube.glsl" becomes INCLUDED_cube_glsl.
std::string guard_of(std::string name) {
  std::replace(name.begin(), name.end(), '.', '_');
  return "INCLUDED_" + name;
}

/// Adds a file's lines, and in the place of each #include those of the file that it names. The compiler passes over all
/// but the first of a file that it reaches: only it knows which of them are in a part that is left out. `open` holds
/// the files around this one: each is read before its #ifndef has any effect.
void add_file(ShaderFiles& files, const std::string& name, std::vector<std::string>& open, ShaderText& shader) {
  open.push_back(name);
  const int number = static_cast<int>(shader.files.size());
  shader.files.push_back(name);
  std::istringstream lines(files.text(name));
  shader.text += fmt::format("#line 1 {}\n", number);
  std::string line;
  for (int row = 1; std::getline(lines, line); ++row) {
    const std::optional<std::string> wanted = ShaderFiles::included_name(line);
    if (!wanted) {
      shader.text += line + "\n";
      // A compiler counts the lines that it passes over, and those of files among them.
      if (line.rfind("#e", 0) == 0) shader.text += fmt::format("#line {} {}\n", row + 1, number);
      continue;
    }
    if (const auto around = std::find(open.begin(), open.end(), *wanted); around != open.end())
      throw InputError(fmt::format("{}:{}: {} includes itself{}", name, row, *wanted,
                                   *wanted == name ? "" : fmt::format(", by way of {}", name)));
    shader.text += fmt::format("#ifndef {0}\n#define {0}\n", guard_of(*wanted));
    add_file(files, *wanted, open, shader);
    shader.text += fmt::format("#endif\n#line {} {}\n", row + 1, number);
  }
  open.pop_back();
}

constexpr int lines_of_a_file = 100'000;  // in a text with numbered files; those below are of none

/// Takes this word off the front of a text, if it is there.
bool skip(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  return true;
}

}  // namespace

ShaderText shader_text(ShaderFiles& files, std::string_view file, ShaderStage stage, Api api,
                       std::string_view definitions) {
  ShaderText shader;
  shader.text = api == Api::desktop ? desktop_head : embedded_head;
  const std::string_view way = stage == ShaderStage::vertex ? "out" : "in";
  shader.text += fmt::format("#define CARRIED {0}\n#define CARRIED_FLAT flat {0}\n", way);
  shader.text += names;
  shader.text += definitions;
  std::vector<std::string> open;
  add_file(files, std::string(file), open, shader);
  return shader;
}

std::string with_numbered_files(const ShaderText& shader) {
  constexpr std::string_view directive = "#line ";
  std::istringstream lines(shader.text);
  std::string numbered;
  for (std::string line; std::getline(lines, line); numbered += line + "\n") {
    std::string_view place = line;
    if (!skip(place, directive)) continue;
    const int row = take_integer<int>(place).value_or(0);
    skip(place, " ");
    const int file = take_integer<int>(place).value_or(0);
    line = fmt::format("{}{}", directive, (file + 1) * lines_of_a_file + row);
  }
  return numbered;
}

// Mesa writes "0:200015(7): error: ...", NVIDIA "0(200015) : error ...", others "ERROR: 0:200015: ...".
std::string compiler_words(const ShaderText& shader, std::string_view log) {
  const std::string_view line = log.substr(0, log.find('\n'));
  std::string_view rest = line;
  const bool error_first = skip(rest, "ERROR: ");
  if (!take_integer<int>(rest)) return std::string(line);
  const bool bracket = skip(rest, "(");
  if (!bracket && !skip(rest, ":")) return std::string(line);
  const std::size_t number = take_integer<std::size_t>(rest).value_or(0), file = number / lines_of_a_file;
  if (file == 0 || file > shader.files.size()) return std::string(line);
  if (bracket && skip(rest, ")")) skip(rest, " ");
  std::string what(rest);
  if (error_first && rest.starts_with(": ")) what.insert(2, "error: ");
  return fmt::format("{}:{}{}", shader.files[file - 1], number % lines_of_a_file, what);
}

}  // namespace ps::hardware
