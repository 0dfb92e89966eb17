#pragma once
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "engine/maths.h"

namespace ps {

/// A command for one sign: \alpha, \cdot, \sin.
struct SignCommand {
  std::string_view name;  ///< without the backslash
  MathsSign sign;
};

const SignCommand* find_sign_command(std::string_view name);
std::span<const SignCommand> sign_commands();

/// The sign that a byte of the notation means without a command, such as '+'; none for others.
std::optional<MathsSign> sign_of_byte(char byte);

/// The command that writes this character, with its backslash; empty if there is none.
std::string_view command_of_character(std::string_view utf8);

}  // namespace ps
