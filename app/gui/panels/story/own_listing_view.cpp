#include "gui/panels/story/own_listing_view.h"

#include <fmt/format.h>

#include <utility>

#include "base/enumerators.h"
#include "base/read_file.h"
#include "gui/panels/story/listing_code.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

/// A shows the listing's own picture, so that B is beside what it should be.
void compare_with_listing(Session& session, const NamedListing& listing) {
  session.edit("compare with your listing", [&](Document& document) {
    document.a.settings = settings_of_listing(listing, document.a.settings);
    if (document.compare == CompareMode::only_a || document.compare == CompareMode::only_b)
      document.compare = CompareMode::side_by_side;
  });
}

void begin_file(Session& session, OwnListingState& state, PermittedListing file, const NamedListing* listing) {
  state.watch.watch({file.file()});
  state.file = std::move(file);
  ++state.opened;
  state.saves = 0;
  state.shown_saves = -1;
  state.stopped = false;
  state.taken.reset();
  state.view.reset();
  state.rows.clear();
  state.pictures = -1;
  if (listing) compare_with_listing(session, *listing);
}

/// The line that is shown for a line of the file: that of its statement where it is a watch.
int shown_line(const OwnListingState& state, int line) {
  if (!state.text || line < 0 || static_cast<std::size_t>(line) >= state.text->shown_at.size()) return 0;
  const int at = state.text->shown_at[static_cast<std::size_t>(line)];
  return at < 0 ? 0 : state.text->lines[static_cast<std::size_t>(at)].number;
}

std::string message_text(const CompilerMessage& message) {
  const std::string_view word = enumerator_key(message.kind);
  return message.line > 0 ? fmt::format("{}, line {}: {}", word, message.line, message.text)
                          : fmt::format("{}: {}", word, message.text);
}

void take_outcome(Session& session, OwnListingState& state) {
  const auto outcome = state.worker.result();
  if (!outcome || outcome == state.taken || outcome->opened != state.opened) return;
  if (!state.taken || state.taken->saves != outcome->saves || !outcome->compilation.messages.empty())
    state.reveal = true;
  state.taken = outcome;
  state.view.reset();
  state.text = std::make_unique<ListingText>(parse_listing(outcome->compilation.source));
  static const ListingTrace nothing;
  state.view.emplace(outcome->trace ? *outcome->trace : nothing, *state.text);
  state.rows = state.view->rows();
  if (outcome->failure.empty() && outcome->pictures != state.pictures) {
    state.pictures = outcome->pictures;
    state.shown_saves = outcome->saves;
    session.open_picture_b(outcome->picture_file);
  }
}

/// Its picture was shown and something else was put in its place: it waits to be saved, or asked for again.
bool put_aside(const Session& session, const OwnListingState& state) {
  return state.shown_saves == state.saves && state.taken && session.document().picture_b != state.taken->picture_file;
}

std::string state_text(const Session& session, const OwnListingState& state) {
  if (put_aside(session, state))
    return "Another picture has taken B's place. Save the file, or show its picture again.";
  if (state.worker.busy()) return "Compiling and running ...";
  if (!state.taken) return "";
  const OwnOutcome& outcome = *state.taken;
  if (!outcome.failure.empty()) return outcome.failure;
  return verdict_text(outcome.wrong, outcome.size.x, outcome.size.y);
}

void file_row(Session& session, OwnListingState& state) {
  const bool busy = state.worker.busy();
  if (button("stop", "Stop", Emphasis::plain,
             {.tooltip = "Ends the compiler or the program; both begin again when the file is saved.",
              .disabled = busy ? "" : "Nothing is running."}))
    state.stopped = true;
  const bool wrong = state.taken && state.taken->failure.empty() && state.taken->wrong.count > 0;
  same_line_if_room(button_width("First wrong pixel"));
  if (button("first", "First wrong pixel", Emphasis::plain,
             {.tooltip = "Picks the first pixel, row by row from the top, that differs from the listing's picture.",
              .disabled = wrong ? "" : "No pixel is known to be wrong."}))
    session.set_pixel(state.taken->wrong.first);
  if (put_aside(session, state)) {
    same_line_if_room(button_width("Show as B"));
    if (button("show", "Show as B", Emphasis::primary,
               {.tooltip = "Runs it on this scene and puts its picture in B."})) {
      state.shown_saves = -1;
      state.pictures = -1;
      ++state.opened;
    }
  }
  same_line_if_room(button_width("Close"));
  if (button("close", "Close", Emphasis::quiet, {.tooltip = "Shows the lesson's listing again; the file stays."})) {
    state.file.reset();
    if (state.taken && session.picture_b() && session.document().picture_b == state.taken->picture_file)
      session.close_picture_b();
    return;
  }
  const std::filesystem::path& file = state.file->file();
  const FontScope font(Face::mono_small);
  value_paragraph("file", file.filename().string());
  value_paragraph("folder", "in " + file.parent_path().string());
  tooltip("Edit this file with any editor. It is compiled and run each time that you save it.");
  value_paragraph("protection", protection_sentence());
}

}  // namespace

void update_own_listing(Session& session, OwnListingState& state) {
  if (!state.watch.take_changed().empty()) {
    ++state.saves;
    state.stopped = false;
  }
  if (state.worker.has_news()) state.worker.take_news();
  if (!state.file) {
    if (state.worker.busy()) state.worker.request({});  // ends what runs
    return;
  }
  if (!session.has_scene()) return;
  if (put_aside(session, state)) return state.worker.rest();
  OwnRequest request;
  request.file = state.file;
  request.opened = state.opened;
  request.saves = state.saves;
  request.stopped = state.stopped;
  request.picture.scene = session.scene();
  request.picture.view = session.view();
  request.picture.settings = session.settings(Side::a);
  request.pixel = session.pixel();
  state.worker.request(request);
  take_outcome(session, state);
}

bool own_listing_busy(const OwnListingState& state) {
  return state.file && (!state.taken || state.worker.busy() || state.worker.has_news());
}

void own_listing_buttons(Session& session, OwnListingState& state, const NamedListing* listing,
                         const std::function<void(FileQuestion)>& ask_file) {
  const std::string routine = listing && state.task.lesson == listing->folder ? state.task.routine : "";
  const std::string label = routine.empty() ? "Copy this listing" : fmt::format("Write {}", routine);
  same_line_if_room(button_width(label));
  if (button("copy", label, routine.empty() ? Emphasis::plain : Emphasis::primary,
             {.tooltip =
                  "Makes a file of your own from this listing. Each time that you save it, it is compiled and run, "
                  "and its picture is shown as B.",
              .disabled = listing ? "" : "There is no listing to copy, or it would answer the question."})) {
    try {
      state.problem.clear();
      begin_file(session, state, state.permits.copy(*listing, routine), listing);
      session.say(Message::Kind::information, fmt::format("Your copy is {}.", state.file->file().string()));
    } catch (const InputError& error) {
      state.problem = error.what();
    }
  }
  same_line_if_room(button_width("Open a copy..."));
  if (button("open", "Open a copy...", Emphasis::quiet, {.tooltip = "Goes on with a copy that was made before."}))
    ask_file({.title = "Open your copy of a listing",
              .use = FileUse::open,
              .extensions = {".cpp"},
              .hint = "listing.cpp",
              .answer = [&state](const FileAnswer& file) { state.asked = file.path; }});
  if (!state.problem.empty()) quiet_text(state.problem);
}

bool own_listing_question(Session& session, OwnListingState& state) {
  if (state.asked.empty()) return false;
  const NameScope scope("own");
  value_paragraph("asked", state.asked.string());
  value_paragraph("rights", fmt::format("{} {}", own_rights_sentence(), protection_sentence()));
  const std::filesystem::path file = state.asked;
  if (button("allow", "Compile and run it", Emphasis::primary)) {
    state.asked.clear();
    try {
      state.problem.clear();
      PermittedListing permitted = state.permits.permit(file);
      const NamedListing* listing = copied_listing(read_whole_file(permitted.file(), 1u << 20));
      begin_file(session, state, std::move(permitted), listing);
    } catch (const InputError& error) {
      state.problem = error.what();
    }
  }
  ImGui::SameLine();
  if (button("refuse", "Do not", Emphasis::quiet)) state.asked.clear();
  return true;
}

void own_listing_view(Session& session, OwnListingState& state) {
  const NameScope scope("own");
  file_row(session, state);
  if (!state.file) return;
  value_paragraph("state", state_text(session, state));
  if (!state.taken) return;
  LineMarks marks;
  marks.routine = state.task.routine;
  for (const CompilerMessage& message : state.taken->compilation.messages) {
    const int line = shown_line(state, message.line);
    std::string& text = line > 0 ? marks.faults[line] : marks.elsewhere;
    text += (text.empty() ? "" : "\n") + message_text(message);
  }
  if (!marks.elsewhere.empty()) value_paragraph("messages", marks.elsewhere);
  if (!state.taken->printed.empty()) {
    constexpr std::size_t most_shown = 600;
    value_paragraph("printed", "It printed: " + state.taken->printed.substr(0, most_shown));
  }
  ImGui::Spacing();
  const auto stepped = listing_code(state.rows, std::exchange(state.reveal, false), marks);
  if (stepped && state.view) {
    state.view->step(stepped->row, stepped->by);
    state.rows = state.view->rows();
  }
}

void offer_own_values(Values& out, const OwnListingState& state) {
  out.offer("own/open", [&state] { return state.file.has_value(); });
  out.offer("own/path", [&state] { return state.file ? state.file->file().string() : ""; });
  out.offer("own/saves", [&state] { return state.saves; });
  out.offer("own/wrong", [&state] { return state.taken ? static_cast<int>(state.taken->wrong.count) : -1; });
  out.offer("own/errors",
            [&state] { return state.taken ? static_cast<int>(state.taken->compilation.messages.size()) : 0; });
  out.offer("own/seconds", [&state] { return state.taken ? state.taken->seconds : 0.0; });
}

}  // namespace ps::gui
