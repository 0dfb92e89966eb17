#include "engine/maths_signs.h"

#include <algorithm>
#include <string>

namespace ps {
namespace {

SignCommand letter(std::string_view name, const char* text) {
  return {name, {text, MathsStyle::italic, MathsRole::ordinary}};
}
SignCommand upright(std::string_view name, const char* text, MathsRole role = MathsRole::ordinary) {
  return {name, {text, MathsStyle::upright, role}};
}
SignCommand function(std::string_view name) { return upright(name, name.data(), MathsRole::function); }
SignCommand with_limits(std::string_view name) {
  return {name, {std::string(name), MathsStyle::upright, MathsRole::function, false, true}};
}
SignCommand large(std::string_view name, const char* text, bool limits) {
  return {name, {text, MathsStyle::upright, MathsRole::function, true, limits}};
}

/// Only signs for which the window's fonts have glyphs; a test compares them.
std::vector<SignCommand> all_sign_commands() {
  constexpr auto binary = MathsRole::binary, relation = MathsRole::relation, opening = MathsRole::opening,
                 closing = MathsRole::closing;
  return {letter("alpha", "α"),
          letter("beta", "β"),
          letter("gamma", "γ"),
          letter("delta", "δ"),
          letter("epsilon", "ε"),
          letter("zeta", "ζ"),
          letter("eta", "η"),
          letter("theta", "θ"),
          letter("kappa", "κ"),
          letter("lambda", "λ"),
          letter("mu", "μ"),
          letter("nu", "ν"),
          letter("xi", "ξ"),
          letter("pi", "π"),
          letter("rho", "ρ"),
          letter("sigma", "σ"),
          letter("tau", "τ"),
          letter("phi", "ϕ"),
          letter("varphi", "φ"),
          letter("chi", "χ"),
          letter("psi", "ψ"),
          letter("omega", "ω"),
          upright("Gamma", "Γ"),
          upright("Delta", "Δ"),
          upright("Theta", "Θ"),
          upright("Lambda", "Λ"),
          upright("Xi", "Ξ"),
          upright("Pi", "Π"),
          upright("Sigma", "Σ"),
          upright("Phi", "Φ"),
          upright("Psi", "Ψ"),
          upright("Omega", "Ω"),
          letter("ell", "ℓ"),
          upright("infty", "∞"),
          upright("partial", "∂"),
          upright("emptyset", "∅"),
          upright("degree", "°"),
          upright("prime", "′"),
          upright("ldots", "…"),
          upright("cdots", "⋯"),
          upright("forall", "∀"),
          upright("exists", "∃"),
          upright("perp", "⊥", relation),
          upright("parallel", "∥", relation),
          upright("cdot", "·", binary),
          upright("times", "×", binary),
          upright("div", "÷", binary),
          upright("pm", "±", binary),
          upright("circ", "∘", binary),
          upright("otimes", "⊗", binary),
          upright("oplus", "⊕", binary),
          upright("cap", "∩", binary),
          upright("cup", "∪", binary),
          upright("le", "≤", relation),
          upright("ge", "≥", relation),
          upright("ne", "≠", relation),
          upright("approx", "≈", relation),
          upright("equiv", "≡", relation),
          upright("sim", "∼", relation),
          upright("in", "∈", relation),
          upright("notin", "∉", relation),
          upright("subset", "⊂", relation),
          upright("to", "→", relation),
          upright("gets", "←", relation),
          upright("mapsto", "↦", relation),
          upright("Rightarrow", "⇒", relation),
          upright("iff", "⇔", relation),
          upright("lvert", "|", opening),
          upright("rvert", "|", closing),
          upright("lVert", "‖", opening),
          upright("rVert", "‖", closing),
          upright("lfloor", "⌊", opening),
          upright("rfloor", "⌋", closing),
          upright("lceil", "⌈", opening),
          upright("rceil", "⌉", closing),
          upright("langle", "⟨", opening),
          upright("rangle", "⟩", closing),
          upright("{", "{", opening),
          upright("}", "}", closing),
          upright("%", "%"),
          upright("#", "#"),
          function("sin"),
          function("cos"),
          function("tan"),
          function("arcsin"),
          function("arccos"),
          function("arctan"),
          function("log"),
          function("ln"),
          function("exp"),
          function("det"),
          with_limits("min"),
          with_limits("max"),
          with_limits("lim"),
          large("sum", "∑", true),
          large("prod", "∏", true),
          large("int", "∫", false)};
}

}  // namespace

std::span<const SignCommand> sign_commands() {
  static const std::vector<SignCommand> commands = all_sign_commands();
  return commands;
}

const SignCommand* find_sign_command(std::string_view name) {
  const auto commands = sign_commands();
  const auto found =
      std::find_if(commands.begin(), commands.end(), [&](const auto& each) { return each.name == name; });
  return found == commands.end() ? nullptr : &*found;
}

std::optional<MathsSign> sign_of_byte(char byte) {
  switch (byte) {
  case '+':
    return MathsSign{"+", MathsStyle::upright, MathsRole::binary};
  case '-':
    return MathsSign{"−", MathsStyle::upright, MathsRole::binary};
  case '=':
  case '<':
  case '>':
  case ':':
    return MathsSign{std::string(1, byte), MathsStyle::upright, MathsRole::relation};
  case '(':
  case '[':
    return MathsSign{std::string(1, byte), MathsStyle::upright, MathsRole::opening};
  case ')':
  case ']':
  case '!':
    return MathsSign{std::string(1, byte), MathsStyle::upright, MathsRole::closing};
  case ',':
  case ';':
    return MathsSign{std::string(1, byte), MathsStyle::upright, MathsRole::punctuation};
  case '/':
  case '.':
  case '|':
  case '?':
    return MathsSign{std::string(1, byte), MathsStyle::upright, MathsRole::ordinary};
  default:
    return {};
  }
}

std::string_view command_of_character(std::string_view utf8) {
  for (const SignCommand& each : sign_commands())
    if (each.sign.text == utf8) return each.name;
  return {};
}

}  // namespace ps
