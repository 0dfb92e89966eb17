#include "gui/panels/story/listing_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>
#include <string_view>
#include <utility>

#include "gui/base/values.h"
#include "gui/panels/story/listing_code.h"
#include "gui/panels/story/own_listing_view.h"
#include "gui/panels/story/shown_field.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"
#include "image/display.h"
#include "options/renderer_kind.h"
#include "textbook/listing_field.h"

namespace ps::gui {
namespace {

constexpr double choice_width = 250, code_width = 190, menu_width = 430;
constexpr std::array<std::string_view, 6> menu_controls{"which", "picture", "copy", "open", "colour", "fill"};

/// The listing that is shown: the one that the option names, else the open lesson's, else what suits the scene.
Settings listing_settings(const Session& session, Side side) {
  Settings settings = session.settings(side);
  if (!runs_listing(settings.renderer)) settings.listing_bug = 0;  // it does not act there
  settings.renderer = renderer_for(PictureWay::listing);
  if (settings.listing > 0) return settings;
  const auto all = listings();
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].folder == session.document().lesson) settings.listing = static_cast<int>(i) + 1;
  return settings;
}

/// `instance`: the run of a loop that was stepped to; -1 = none.
void take_up(ListingPanelState& state, const std::shared_ptr<const PixelStory>& story, int instance) {
  if (story == state.shown_story && instance == state.instance) return;
  state.instance = instance;
  state.view.reset();
  state.rows.clear();
  state.shown_story = story;
  if (!story || !story->listing) return;
  const NamedListing& listing = story->listing->listing;
  if (listing.folder != state.folder || listing.bug != state.bug || !state.text) {
    state.folder = listing.folder;
    state.bug = listing.bug;
    state.reveal = true;
    state.error.clear();
    try {
      state.text = std::make_unique<ListingText>(load_listing_text(listing));
    } catch (const InputError& error) {
      state.text = std::make_unique<ListingText>();
      state.error = error.what();
    }
  }
  state.view.emplace(*story->listing, *state.text);
  if (instance >= 0 && static_cast<std::size_t>(instance) < story->listing->instances.size())
    state.view->focus(instance);
  state.rows = state.view->rows();
}

std::string levels_text(const std::array<int, 3>& c) { return fmt::format("{} {} {}", c[0], c[1], c[2]); }

void choose_code(ListingPanelState& state) {
  static constexpr std::array kinds{Choice{"shaders", "Shaders", "The shaders that drew the picked pixel."},
                                    Choice{"routine", "Routine", "A lesson's routine, in C++."}};
  choice_of("code", kinds, state.code, {.tooltip = "What is listed.", .width = px(code_width)});
}

/// Whether there is room behind the item that was drawn last.
bool fill_has_room() {
  const float right = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x;
  return ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + button_width("Fill") <= right;
}

/// Answers whether to fill the window, or no longer.
bool fill_by_button(bool filled) {
  return fill_button(filled, "Shows the listing in the whole window; Esc goes back.");
}

/// The listing that is shown, without a bug in it; nullptr if none is.
const NamedListing* copied_from(const ListingPanelState& state) {
  for (const NamedListing& listing : listings())
    if (state.text && listing.folder == state.folder) return &listing;
  return nullptr;
}

/// The routine of this listing that the open step asks to write; empty if it asks for none.
std::string asked_routine(const ListingPanelState& state) {
  const NamedListing* listing = copied_from(state);
  return listing && state.own.task.lesson == listing->folder ? state.own.task.routine : "";
}

/// The first routine of these lines that the step's text names, if its name has an underscore: words like "edge" are in
/// other sentences too. Empty if none is.
std::string named_routine(const Lesson* lesson, int step, const std::vector<ListingRow>& rows) {
  if (!lesson || static_cast<std::size_t>(step) >= lesson->steps.size()) return {};
  for (const TextBlock& block : lesson->steps[static_cast<std::size_t>(step)].blocks) {
    std::string words = plain_text(block);
    std::replace_if(
        words.begin(), words.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)) && c != '_'; },
        ' ');
    std::istringstream text(words);
    for (std::string word; text >> word;)
      if (word.find('_') != std::string::npos && std::any_of(rows.begin(), rows.end(), [&](const ListingRow& row) {
            return !row.text.starts_with(' ') && row.text.find(' ' + word + '(') != std::string::npos;
          }))
        return word;
  }
  return {};
}

/// The side whose picture and pixel the listing is about: a question about a wrong line is one about that of A, where
/// the line is marked afterwards, and the listing of B is the answer.
Side listed_side(const Session& session, const ListingPanelState& state) {
  return state.marks.answer || state.marks.marked ? Side::a : inspected_side(session);
}

/// Which routine is shown, its picture, and copies of it.
void routine_controls(Session& session, ListingPanelState& state, Side side, const PanelHost& host) {
  const Option* option = find_option("listing");
  int index = session.settings(side).listing;
  if (drop_down("which", option->choices, index, px(choice_width), {.tooltip = "The lesson whose routine is shown."})) {
    Settings settings = session.settings(side);
    settings.listing = index;
    session.navigate([](Document& document) { document.story.listing_instance = -1; });
    session.set_settings(side, settings, fmt::format("{}: another listing", letter_of(side)));
  }
  const bool shown = runs_listing(session.settings(side).renderer);
  const std::string label = fmt::format("Its picture in {}", letter_of(side));
  same_line_if_room(button_width(label));
  if (button_on_off(
          "picture", label, shown,
          {.tooltip = "Renders the picture with the listing. Again: with the ray tracer or the rasterizer."})) {
    Settings settings = session.settings(side);
    const bool rays = state.shown_story && state.shown_story->listing &&
                      state.shown_story->listing->listing.listing->order == ListingOrder::pixel_by_pixel;
    settings.renderer = renderer_for(!shown ? PictureWay::listing : rays ? PictureWay::rays : PictureWay::fragments);
    session.set_settings(side, settings, fmt::format("{}: {}", letter_of(side), renderer_label(settings.renderer)));
  }
  own_listing_buttons(session, state.own, state.marks.answer ? nullptr : copied_from(state), host.ask_file);
}

/// The pixel's colour by the listing, and in the picture.
std::string colours_text(const Session& session, const ListingPanelState& state, Side side) {
  if (!state.shown_story) return {};
  const std::string source(state.shown_story->listing ? state.shown_story->listing->listing.listing->source : "");
  std::string colours = fmt::format("{} gives {}", source, levels_text(state.shown_story->display));
  if (const auto story = session.story(side); story && !runs_listing(session.settings(side).renderer))
    colours += fmt::format(", {} has {}", letter_of(side), levels_text(story->display));
  return colours;
}

void colours_line(const std::string& colours) {
  value_paragraph("colour", colours, {Face::mono_small});
  tooltip("The pixel's colour by this listing, and in the picture: red, green and blue, 0 to 255.");
}

bool toolbar(Session& session, ListingPanelState& state, Side side, bool filled, const PanelHost& host) {
  routine_controls(session, state, side, host);
  const bool fill = fill_by_button(filled);
  if (const std::string colours = colours_text(session, state, side); !colours.empty()) {
    same_line_if_room(text_width(colours, Face::mono_small), px(16));
    colours_line(colours);
  }
  return fill;
}

/// Whether the panel shows a lesson's routine, and not shaders or a file of one's own.
bool shows_routine(const Session& session, const ListingPanelState& state) {
  if (!session.has_scene() || !session.pixel() || !state.own.asked.empty()) return false;
  if (state.own.file && !state.marks.answer) return false;
  return state.code == ListingPanelState::Code::routine || !has_shaders(session.settings(listed_side(session, state)));
}

/// A script looks for a control of the menu that head() has.
bool wanted_from_menu() {
  const std::string_view wanted = controls().revealing();
  return std::any_of(menu_controls.begin(), menu_controls.end(),
                     [&](std::string_view name) { return wanted.starts_with(full_name(name)); });
}

}  // namespace

ListingPanel::ListingPanel(const PanelHost& host, LessonShelf& shelf, LessonQuestions& questions)
    : Panel(host, {.name = "listing",
                   .height = PanelHeight::tall,
                   .answers = Answers::yes,
                   .heading = "Listing",
                   .brief = "Listing",
                   .command = "Listing: a routine with its values",
                   .help = "A lesson's routine, or the shaders, with their values at the picked pixel."}),
      shelf_(shelf), questions_(questions), state_(host.wake) {}

void ListingPanel::offer(Values& out) {
  const auto values_of = [this] {
    return state_.shown_story && state_.shown_story->listing ? &*state_.shown_story->listing : nullptr;
  };
  out.offer("listing/focus", [this] { return state_.view ? state_.view->focus() : -1; });
  out.offer("listing/folder", [=] { return values_of() ? values_of()->listing.folder : ""; });
  out.offer("listing/values", [=] { return values_of() ? static_cast<int>(values_of()->watches.size()) : 0; });
  offer_shader_values(out, state_.shaders);
  offer_own_values(out, state_.own);
}

/// Marks for a question about the wrong line, and the routine that a step asks for.
void ListingPanel::follow_lesson() {
  const bool asks_bug = questions_.asked_beside_text(session_) && questions_.question()->kind == AskKind::bug;
  auto wrong_line = questions_.bug_verdict(session_);
  state_.reveal |= wrong_line && !state_.marks.marked;
  state_.marks = {asks_bug && questions_.bug_shown(session_) ? &questions_.answer.line : nullptr,
                  std::move(wrong_line)};
  state_.own.task = {};
  const Lesson* lesson = shelf_.open();
  const auto step = static_cast<std::size_t>(session_.document().step);
  if (lesson && step < lesson->steps.size()) state_.own.task = {lesson->name, lesson->steps[step].write};
  // A question for a wrong line is one about its routine, which is known once the line is.
  const auto right = asks_bug ? questions_.right() : nullptr;
  state_.marks.within = right ? right->line.number : 0;
  state_.reveal |= std::exchange(state_.opened_within, state_.marks.within) != state_.marks.within;
}

void ListingPanel::update() {
  follow_lesson();
  state_.worker.take_news();
  update_shaders(session_, state_.shaders);
  update_own_listing(session_, state_.own);
}

bool ListingPanel::busy() const {
  return works(state_.worker) || shaders_busy(state_.shaders) || own_listing_busy(state_.own);
}

bool ListingPanel::head() {
  Session& session = session_;
  ListingPanelState& state = state_;
  const NameScope scope("listing");
  if (!shows_routine(session, state)) return false;
  const bool writes = !asked_routine(state).empty();
  if (button("more", "More", writes ? Emphasis::primary : Emphasis::quiet,
             {.tooltip = writes ? "Write the routine that the step asks for, or choose another one."
                                : "Another routine, its picture, and copies of it."}) ||
      wanted_from_menu())
    ImGui::OpenPopup("listing-more");
  const ImVec2 corner{ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y + px(2)};
  const bool room = fill_has_room();
  bool fill = room && fill_by_button(false);
  ImGui::SetNextWindowPos(corner);
  ImGui::SetNextWindowSizeConstraints({px(menu_width), 0}, {px(menu_width), px(menu_width)});
  if (ImGui::BeginPopup("listing-more")) {
    const Side side = listed_side(session, state);
    routine_controls(session, state, side, host_);
    if (!room && fill_by_button(false)) {
      fill = true;
      ImGui::CloseCurrentPopup();
    }
    if (const std::string colours = colours_text(session, state, side); !colours.empty()) colours_line(colours);
    ImGui::EndPopup();
  }
  return fill;
}

bool ListingPanel::draw(const Context& context) {
  Session& session = session_;
  ListingPanelState& state = state_;
  const bool filled = context.filled;
  const NameScope scope("listing");
  if (!session.has_scene()) return false;
  if (own_listing_question(session, state.own)) return false;
  if (state.own.file && !state.marks.answer) {
    show_text("Your file");
    const bool fill = fill_by_button(filled);
    same_line_if_room(button_width("Stop"));
    own_listing_view(session, state.own);
    return fill;
  }
  const Side side = listed_side(session, state);
  const auto pixel = session.pixel();
  if (!pixel) {
    state.worker.clear();
    take_up(state, nullptr, -1);
    quiet_text("Click a pixel to see a lesson's routine with the values that its lines have there.");
    return false;
  }
  if (has_shaders(session.settings(side))) {
    choose_code(state);
    if (state.code == ListingPanelState::Code::shaders) {
      const bool fill = fill_by_button(filled);
      shader_panel(session, state.shaders, side, *pixel);
      return fill;
    }
  }
  StoryRequest request;
  request.picture.scene = session.scene();
  request.picture.view = session.view();
  request.picture.settings = listing_settings(session, side);
  request.pixel = *pixel;
  state.worker.request(request);
  take_up(state, state.worker.story(), session.document().story.listing_instance);
  const bool fill = !context.headed && toolbar(session, state, side, filled, host_);
  if (!state.error.empty()) quiet_text(state.error);
  if (!state.view) {
    if (const auto message = state.worker.message(); !message.empty()) quiet_text(message);
    return fill;
  }
  begin_tool_content();
  LineMarks marks = side == Side::a ? state.marks : LineMarks{};
  marks.routine = asked_routine(state);
  if (marks.routine.empty()) marks.routine = named_routine(shelf_.open(), session.document().step, state.rows);
  if (state.shown_story->listing->watches.empty())
    marks.remark = "No line of this routine reached the pixel: it draws nothing here.";
  const ListingTrace& trace = *state.shown_story->listing;
  const auto query = [&](int watch, int component) {
    const Settings& settings = session.settings(side);
    const bool drawn = runs_listing(settings.renderer) &&
                       running_listing(settings, scene_traits(session.scene())).listing == trace.listing.listing;
    return drawn ? listing_query(trace, static_cast<std::size_t>(watch), component) : std::nullopt;
  };
  marks.can_show = [&](int watch, int component) { return query(watch, component).has_value(); };
  const auto stepped = listing_code(state.rows, std::exchange(state.reveal, false), marks);
  if (stepped && stepped->watch >= 0) {
    if (const auto asked = query(stepped->watch, stepped->component)) show_field(session, *asked);
  } else if (stepped) {
    state.view->step(stepped->row, stepped->by);
    state.instance = state.view->focus();
    state.rows = state.view->rows();
    session.navigate([&](Document& document) { document.story.listing_instance = state.instance; });
  }
  return fill;
}

}  // namespace ps::gui
