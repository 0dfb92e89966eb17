#pragma once
#include <string>
#include <vector>

#include "document/document.h"

namespace ps {

/// The commands that reproduce what a document shows, ready to be pasted into a shell. Options are written as what
/// differs from the scene's own settings.

/// Makes the picture of one side: "pixelscope-cli render cgfs/shadows --size 600x600 --set ... --out picture.png".
std::string render_command(const Document& document, Side side, const std::string& output = "picture.png");
/// Prints the story of the picked pixel; of pixel 0,0 if none is picked.
std::string inspect_command(const Document& document, Side side);
/// Measures a chart around the settings of one side. `arguments` are those of `chart` itself ("--sweep", "samples").
std::string chart_command(const Document& document, Side side, const std::vector<std::string>& arguments);
/// The same in short: everything is in the permalink. Both act on the side whose pixel is picked; `inspect` needs one.
enum class LinkedCommand { render, inspect };
std::string linked_command(const Document& document, LinkedCommand command);
/// Opens the window as it is now.
std::string window_command(const Document& document);

/// `text` as one word of a POSIX shell.
std::string shell_quote(const std::string& text);

}  // namespace ps
