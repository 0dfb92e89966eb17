#include "hardware/shader_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>
#include <sstream>

#include "hardware/condition.h"
#include "hardware/shader_text.h"

namespace ps::hardware {
namespace {

/// An #if that is open.
struct Branch {
  bool around = true;    ///< what is around it is compiled
  bool taken = false;    ///< one of its parts was
  bool compiled = true;  ///< this part is
};

std::string_view without_comment(std::string_view line) { return line.substr(0, line.find("//")); }

/// What follows a directive, or nothing if the line is another.
std::optional<std::string_view> after(std::string_view line, std::string_view directive) {
  if (!line.starts_with(directive)) return {};
  return without_comment(line.substr(directive.size()));
}

/// The name that a line declares as a uniform: the last word before its semicolon or bracket.
std::string declared_name(std::string_view line) {
  line = line.substr(0, line.find_first_of(";["));
  std::size_t end = line.size();
  while (end > 0 && std::isspace(static_cast<unsigned char>(line[end - 1]))) --end;
  std::size_t begin = end;
  while (begin > 0 && (std::isalnum(static_cast<unsigned char>(line[begin - 1])) || line[begin - 1] == '_')) --begin;
  return std::string(line.substr(begin, end - begin));
}

class LineReader {
 public:
  LineReader(ShaderFiles& files, std::string_view definitions, const UniformTexts& uniforms)
      : files_(files), uniforms_(uniforms), definitions_(read_definitions(shader_constants())) {
    definitions_.merge(read_definitions(definitions));
  }

  void read(const std::string& name) {
    included_.insert(name);
    const std::size_t place = read_.size();
    read_.push_back({name, {}});
    std::istringstream text(files_.text(name));
    int number = 0;
    for (std::string line; std::getline(text, line);) {
      ShaderLine made{line, ++number, compiled(), {}};
      look_at(line, made);
      read_[place].lines.push_back(std::move(made));
    }
  }
  std::vector<ShaderFile> take() { return std::move(read_); }

 private:
  bool compiled() const { return branches_.empty() || branches_.back().compiled; }

  void look_at(const std::string& line, ShaderLine& made) {
    if (const auto condition = after(line, "#if ")) {
      const bool around = compiled(), holds = around && decide(*condition, made);
      branches_.push_back({around, holds, holds});
    } else if (const auto other = after(line, "#elif ")) {
      Branch& branch = branches_.back();
      branch.compiled = branch.around && !branch.taken && decide(*other, made);
      branch.taken = branch.taken || branch.compiled;
      made.compiled = branch.around;
    } else if (after(line, "#else")) {
      Branch& branch = branches_.back();
      branch.compiled = branch.around && !branch.taken;
      made.compiled = branch.around;
    } else if (after(line, "#endif")) {
      made.compiled = branches_.back().around;
      branches_.pop_back();
    } else if (compiled()) {
      look_at_compiled(line, made);
    }
  }

  void look_at_compiled(const std::string& line, ShaderLine& made) {
    if (const auto wanted = ShaderFiles::included_name(line)) {
      if (!included_.contains(*wanted)) read(*wanted);
      return;
    }
    if (line.starts_with("#define")) definitions_.merge(read_definitions(line));
    const std::string_view code = without_comment(line);
    const bool opens = code.find("uniform ") != std::string_view::npos;
    if ((opens || in_block_) && code.find(';') != std::string_view::npos && code.find('}') == std::string_view::npos) {
      const std::string name = declared_name(code);
      const auto found = uniforms_.find(name);
      made.values.push_back({name, found != uniforms_.end() ? found->second : "not used by this program"});
    }
    if (opens && code.find('{') != std::string_view::npos) in_block_ = true;
    if (code.find('}') != std::string_view::npos) in_block_ = false;
  }

  bool decide(std::string_view condition, ShaderLine& made) {
    for (const std::string& name : names_in(condition)) {
      const auto found = definitions_.find(name);
      made.values.push_back({name, found != definitions_.end() ? fmt::format("{}", found->second) : "0"});
    }
    return condition_holds(condition, definitions_);
  }

  ShaderFiles& files_;
  const UniformTexts& uniforms_;
  Definitions definitions_;
  std::vector<Branch> branches_;
  std::set<std::string> included_;
  std::vector<ShaderFile> read_;
  bool in_block_ = false;
};

}  // namespace

std::vector<ShaderFile> shader_lines(ShaderFiles& files, const std::string& name, std::string_view definitions,
                                     const UniformTexts& uniforms) {
  LineReader reader(files, definitions, uniforms);
  reader.read(name);
  return reader.take();
}

}  // namespace ps::hardware
