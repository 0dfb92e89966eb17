#pragma once
#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "document/document.h"

namespace ps::cli {

/// The arguments that say what to look at and how; shared by all commands that render.
struct SceneArguments {
  std::string scene;                  ///< path or built-in name; empty = that of the permalink
  std::string permalink;              ///< the text, or a file that holds one; empty = none
  std::string side;                   ///< "a" or "b" of the permalink; empty = the one whose pixel is picked
  std::string size;                   ///< "WxH"; empty = the scene's canvas
  std::string camera;                 ///< 15 numbers; empty = the scene's camera
  std::vector<std::string> edits;     ///< "path=value"
  std::vector<std::string> settings;  ///< "key=value"
};

void add_scene_arguments(CLI::App& command, SceneArguments& arguments);

/// Loads the scene and applies everything: what the permalink holds first, then the other arguments, which count more.
/// Side A of the document has the settings, whichever side of the permalink they come from. Refuses a bad size or
/// setting before it loads anything. Throws InputError.
Document load_document(const SceneArguments& arguments);

/// "PATH=VALUE" at the first '='. Throws InputError where there is none.
SceneEdit parse_edit(const std::string& text);

}  // namespace ps::cli
