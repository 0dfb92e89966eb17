#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

namespace ps {

/// Bytes that this process can still get: what the system has to spare, or less where a container or a limit of the
/// process (ulimit -v) ends first. nullopt where the system does not say.
std::optional<std::uint64_t> available_memory();

/// The part of `available` bytes that may be used: the rest of the program, and of the computer, needs some too.
std::uint64_t usable_part(std::uint64_t available);

/// Throws InputError if `bytes`, which `what` (plural) need, are more than the usable part of `available`. The message
/// names both, and then `cure`.
void require_memory(std::uint64_t bytes, std::optional<std::uint64_t> available, std::string_view what,
                    std::string_view cure);

}  // namespace ps
