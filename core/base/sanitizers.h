#pragma once

namespace ps {

/// Whether this was compiled with the sanitizer: work then takes many times as long, and much more memory.
#ifdef __has_feature  // clang, and GCC from version 14 on
inline constexpr bool with_address_sanitizer = __has_feature(address_sanitizer);
inline constexpr bool with_thread_sanitizer = __has_feature(thread_sanitizer);
#else
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool with_address_sanitizer = true;
#else
inline constexpr bool with_address_sanitizer = false;
#endif
#ifdef __SANITIZE_THREAD__
inline constexpr bool with_thread_sanitizer = true;
#else
inline constexpr bool with_thread_sanitizer = false;
#endif
#endif

}  // namespace ps
