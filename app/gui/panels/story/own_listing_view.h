#pragma once
#include "gui/panels/panel.h"
#include "gui/panels/story/own_listing.h"
#include "gui/session/session.h"

namespace ps::gui {

/// Takes up what has come and asks for what the document needs; once a frame. A new picture takes B's place.
void update_own_listing(Session& session, OwnListingState& state);
bool own_listing_busy(const OwnListingState& state);

/// "Copy this listing" and "Open a copy...": the only ways to a file that is compiled.
void own_listing_buttons(Session& session, OwnListingState& state, const NamedListing* listing,
                         const std::function<void(FileQuestion)>& ask_file);

/// Asks for a click before a file from the dialog is compiled. Answers whether it asks.
bool own_listing_question(Session& session, OwnListingState& state);

/// The student's file: what the compiler says at its lines, the values of the picked pixel, and where it goes wrong.
void own_listing_view(Session& session, OwnListingState& state);

/// Values for scripts below "own/". The state must outlive the offers.
void offer_own_values(Values& out, const OwnListingState& state);

}  // namespace ps::gui
