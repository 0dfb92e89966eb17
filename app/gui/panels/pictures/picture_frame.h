#pragma once
#include <imgui.h>

#include <optional>
#include <string>

#include "gui/panels/pictures/caption.h"
#include "gui/panels/pictures/picture_captions.h"
#include "gui/panels/pictures/picture_text.h"
#include "gui/panels/pictures/picture_transform.h"
#include "gui/session/session.h"

namespace ps::gui {

/// The lines above and below a picture: what it is made with, which channel is shown, what it cost, what it leaves out.
/// Where a picture is narrow both have two lines instead of one, so that no text that matters is cut. The lines below
/// end with a row for a note, kept free while there is none so that no part jumps.
struct PictureMargins {
  float title = 0, footer = 0;  ///< heights in window pixels
};
PictureMargins picture_margins(float width, PictureCaptions captions);

constexpr double note_height = 24;  ///< of the row for a note, at scale 1

/// The row for a note below a picture, within the rows of its footer; none has room below brief captions.
std::optional<Area> picture_note(const Area& footer, PictureCaptions captions);
/// A triangle that asks for attention, beside a text.
void attention_mark(ImDrawList& list, ImVec2 corner, float size);

/// The letter of a side on its colour.
void side_badge(ImDrawList& list, ImVec2 corner, float size, Side side);

/// The words over a side: those of the technique that A and B compare, or else the settings.
PictureTitle shown_title(Session& session, Side side);

/// Two areas beside or above each other.
struct Halves {
  Area first, second;
};
/// A row over or below a split picture, divided where the picture is: each part lies at its own part of the picture,
/// and reaches beyond it only as far as it needs that. `left` and `right`: the widths that they need.
Halves over_parts(const Area& row, const Area& place, float at, float left, float right, float gap);

/// The width that a side's title needs to be read in full, in a row of this height.
float title_width(Session& session, Side side, float height, PictureCaptions captions);

/// The line above a picture: letter, what it is made with, and which channel is shown. `row` has the height of
/// picture_margins(). `instead`, where it is not empty, replaces what the picture is made with.
void picture_title(Session& session, Side side, const Area& row, PictureCaptions captions = PictureCaptions::full,
                   std::string_view instead = {});

/// The lines below a picture, above its note: the counted work, with what it was before the last change; how long it
/// took, once that has been measured; a thin bar while it is being made. Brief ones name here what the renderer cannot
/// show of the scene. `lead` comes first; `beside` says how it differs from the other picture, where it is not empty.
void picture_footer(Session& session, Side side, CaptionChange& change, const Area& row, PictureCaptions captions,
                    const std::string& lead = {}, const std::string& beside = {});

}  // namespace ps::gui
