#pragma once
#include <filesystem>

namespace ps {

/// Names below the folder of a kit: for the compiler's -I, and for its linker.
inline constexpr const char* kit_headers = "include";
inline constexpr const char* kit_library = "libpixelscope_listing.a";

/// Copies into `folder` what a student's own listing is compiled with: textbook/listing.h with all headers of ours that
/// it includes, and the library. So the compiler needs to see no other folder than this one and the system's. Throws
/// InputError where a file is missing.
void put_listing_kit(const std::filesystem::path& folder);

}  // namespace ps
