#include "document/command_line.h"

#include <fmt/format.h>

#include <algorithm>

#include "document/number_list.h"
#include "document/permalink.h"
#include "options/scene_settings.h"

namespace ps {
namespace {

bool safe_in_shell(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("-_./,:+@=%").find(c) != std::string_view::npos;
}

/// The arguments that `render` and `inspect` share.
std::string scene_arguments(const Document& document, Side side) {
  const View view = view_of(document);
  std::string text = fmt::format(" {} --size {}x{}", shell_quote(document.scene_name), view.width, view.height);
  if (document.view.camera) text += " --camera " + camera_text(*document.view.camera);
  for (const SceneEdit& edit : document.edits) text += " --edit " + shell_quote(edit.path + "=" + edit.value);
  const Settings start = settings_for(document.base);
  for (const std::string& change : settings_difference(start, side_of(document, side).settings))
    text += " --set " + shell_quote(change);
  return text;
}

}  // namespace

std::string render_command(const Document& document, Side side, const std::string& output) {
  std::string text = "pixelscope-cli render" + scene_arguments(document, side);
  const ShownChannel show = side_of(document, side).show;
  if (document.view.region) text += " --region " + region_text(*document.view.region);
  if (show == ShownChannel::field && document.field) {
    text += fmt::format(" --field {}", shell_quote(field_query_text(document.field->query)));
    if (document.field->condition)
      text += fmt::format(" --mark {}", shell_quote(field_condition_text(*document.field->condition)));
  } else if (show != ShownChannel{})
    text += fmt::format(" --show {}", shown_channel(show).key);
  if (const auto& slow = side_of(document, side).slow_motion) text += " --slow-motion " + slow_motion_text(*slow);
  return text + " --out " + shell_quote(output);
}

std::string inspect_command(const Document& document, Side side) {
  return fmt::format("pixelscope-cli inspect{} --pixel {},{}", scene_arguments(document, side),
                     std::max(document.pixel.x, 0), std::max(document.pixel.y, 0));
}

std::string chart_command(const Document& document, Side side, const std::vector<std::string>& arguments) {
  std::string text = "pixelscope-cli chart" + scene_arguments(document, side);
  for (const std::string& argument : arguments) text += " " + shell_quote(argument);
  return text + " --out chart";
}

std::string linked_command(const Document& document, LinkedCommand command) {
  const std::string link = " --permalink " + shell_quote(permalink(document));
  switch (command) {
  case LinkedCommand::render:
    return "pixelscope-cli render" + link + " --out picture.png";
  case LinkedCommand::inspect:
    return "pixelscope-cli inspect" + link;
  }
  return {};
}

std::string window_command(const Document& document) {
  return "pixelscope --permalink " + shell_quote(permalink(document));
}

std::string shell_quote(const std::string& text) {
  if (!text.empty() && std::all_of(text.begin(), text.end(), safe_in_shell)) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

}  // namespace ps
