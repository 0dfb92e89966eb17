#pragma once
#include <string>
#include <string_view>

#include "document/document.h"

namespace ps {

/// Everything on the screen as one line of text, written like the query of a URL:
/// "scene=cgfs/reflections&a.reflection-depth=1&b.renderer=rasterizer&pixel=312,204". Only what differs from the
/// defaults is in it; settings count from the option table's defaults, whatever the scene's file asks for. Characters
/// that a URL or a shell would trip over are percent-escaped.
std::string permalink(const Document& document);

/// The document that a permalink encodes, with its scene's name and edits but without the scene: the caller loads that
/// and calls attach_scene. Throws InputError for text that permalink() would not write.
Document parse_permalink(std::string_view text);

/// Sets the part of a document that `key` names in permalinks: "camera", "pixel", "a.shading",
/// "edit.lights.0.position", "pin". As in a permalink, the scene gets its edits by attach_scene(). Gives false, and
/// leaves the document alone, if no part has this name; throws InputError for a value that permalink() would not write.
bool set_permalink_part(Document& document, std::string_view key, std::string_view value);

/// "#cgfs" as "%23cgfs" and back. Throws InputError for a broken escape.
std::string percent_escape(std::string_view text);
std::string percent_unescape(std::string_view text);

}  // namespace ps
