#pragma once
#include <string>
#include <string_view>

namespace ps {

/// A whole HTML page for paper of the size A4, which is well-formed XML as well. `title` is text, `body` and `footer`
/// are markup.
std::string handout_page(const std::string& title, const std::string& body, const std::string& footer = {});

/// A line to write on.
inline constexpr std::string_view write_here = "<span class=\"write\">&#160;</span>";

}  // namespace ps
