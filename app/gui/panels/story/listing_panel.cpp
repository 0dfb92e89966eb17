#include "gui/panels/story/listing_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "gui/base/values.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/shorten.h"
#include "image/display.h"
#include "options/renderer_kind.h"

namespace ps::gui {
namespace {

constexpr double number_room = 34, choice_width = 250;
constexpr double least_values = 300;  // beside the code; in less room they go below it

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

bool toolbar(Session& session, ListingPanelState& state, Side side, bool filled) {
  const Option* option = find_option("listing");
  int index = session.settings(side).listing;
  if (drop_down("which", option->choices, index, px(choice_width),
                {.tooltip = "The lesson whose routine is shown.", .disabled = {}})) {
    Settings settings = session.settings(side);
    settings.listing = index;
    session.navigate([](Document& document) { document.story.listing_instance = -1; });
    session.set_settings(side, settings, fmt::format("{}: another listing", letter_of(side)));
  }
  const bool shown = runs_listing(session.settings(side).renderer);
  const std::string label = fmt::format("Its picture in {}", letter_of(side));
  same_line_if_room(button_width(label));
  if (button_on_off("picture", label, shown,
                    {.tooltip = "Renders the picture with the listing. Again: with the ray tracer or the rasterizer.",
                     .disabled = {}})) {
    Settings settings = session.settings(side);
    const bool rays = state.shown_story && state.shown_story->listing &&
                      state.shown_story->listing->listing.listing->order == ListingOrder::pixel_by_pixel;
    settings.renderer = renderer_for(!shown ? PictureWay::listing : rays ? PictureWay::rays : PictureWay::fragments);
    session.set_settings(side, settings, fmt::format("{}: {}", letter_of(side), renderer_label(settings.renderer)));
  }
  same_line_if_room(button_width("Fill"));
  const bool fill = button_on_off("fill", "Fill", filled,
                                  {.tooltip = "Shows the listing in the whole window; Esc goes back.", .disabled = {}});
  if (state.shown_story) {
    const std::string source(state.shown_story->listing ? state.shown_story->listing->listing.listing->source : "");
    std::string colours = fmt::format("{} gives {}", source, levels_text(state.shown_story->display));
    if (const auto story = session.story(side); story && !shown)
      colours += fmt::format(", {} has {}", letter_of(side), levels_text(story->display));
    same_line_if_room(text_width(colours), px(16));
    const FontScope font(Face::mono);
    value_paragraph("colour", colours);
    tooltip("The pixel's colour by this listing, and in the picture: red, green and blue, 0 to 255.");
  }
  return fill;
}

std::string instance_text(const ListingRow& row) { return fmt::format("{} {}/{}", row.instance, row.place, row.count); }

float stepper_width(const ListingRow& row) { return text_width(instance_text(row)) + 2 * px(20); }

/// The instance of a loop, with arrows to go to its neighbours.
int stepper(const ListingRow& row, std::size_t index) {
  int by = 0;
  const float line = ImGui::GetTextLineHeight();
  const auto arrow = [&](const char* name, const char* sign, int direction, bool dead) {
    ImGui::PushID(static_cast<int>(index) * 2 + (direction > 0));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size{px(20), line};
    const bool clicked = ImGui::InvisibleButton(name, size) && !dead;
    const bool hovered = ImGui::IsItemHovered() && !dead;
    controls().record(fmt::format("line-{}/{}", row.number, name), sign, !dead);
    if (hovered)
      ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + size.x, at.y + size.y}, colour_u32(palette().field_hover),
                                                px(3));
    draw_text(at, {at.x + size.x, at.y + size.y}, sign, dead ? palette().text_disabled : palette().text, 0.5f);
    ImGui::PopID();
    if (clicked) by = direction;
  };
  arrow("previous", "‹", -1, false);
  ImGui::SameLine(0, 0);
  const std::string text = instance_text(row);
  ImGui::TextUnformatted(whole_words(text, ImGui::GetContentRegionAvail().x - px(20)).c_str());
  controls().record(fmt::format("line-{}/instance", row.number), text);
  ImGui::SameLine(0, 0);
  arrow("next", "›", 1, false);
  return by;
}

/// `left`: where further lines of values begin.
void values(const ListingRow& row, float left) {
  std::string all;
  const float right = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x;
  bool first = true;
  for (const ListingValue& value : row.values) {
    const std::string name = value.name + " = ";
    const float needed = text_width(name) + text_width(value.value);
    if (!first) {
      ImGui::SameLine(0, px(14));
      if (ImGui::GetCursorScreenPos().x + needed > right) ImGui::NewLine();
    }
    if (ImGui::GetCursorScreenPos().x < left || ImGui::GetCursorScreenPos().x + needed > right) {
      if (first && row.loops) ImGui::NewLine();  // the arrows are there
      ImGui::SetCursorScreenPos({left, ImGui::GetCursorScreenPos().y});
    }
    first = false;
    ImGui::PushStyleColor(ImGuiCol_Text, palette().text_quiet);
    ImGui::TextUnformatted(name.c_str());
    ImGui::PopStyleColor();
    if (left + needed <= right)
      ImGui::SameLine(0, 0);
    else
      ImGui::SetCursorScreenPos({left, ImGui::GetCursorScreenPos().y});  // it has lines of its own
    ImGui::TextUnformatted(in_lines(value.value, right - ImGui::GetCursorScreenPos().x).c_str());
    all += (all.empty() ? "" : ", ") + value.name + " = " + value.value;
  }
  if (!row.values.empty()) controls().record(fmt::format("line-{}", row.number), all);
}

/// Code broken at blanks into lines of at most so many signs; what goes on is indented further.
std::string code_lines(const std::string& text, std::size_t signs) {
  const std::size_t start = std::min(text.find_first_not_of(' '), text.size());
  const std::string indent(std::min(start + 4, signs / 2), ' ');
  std::string lines, rest = text;
  while (rest.size() > signs) {
    const std::size_t content = rest.find_first_not_of(' ');
    std::size_t cut = rest.rfind(' ', signs);
    if (cut == std::string::npos || cut <= content) cut = rest.find(' ', content);
    if (cut == std::string::npos) break;
    lines.append(rest, 0, cut).push_back('\n');
    rest.replace(0, cut + 1, indent);
  }
  return lines + rest;
}

bool has_values(const ListingRow& row) { return row.loops || !row.values.empty(); }

struct ListingColumns {
  float code = 0;       ///< where the code begins
  float values = 0;     ///< where the values begin; 0 = below the code
  float character = 0;  ///< width of one
};

ListingColumns columns_for(const std::vector<ListingRow>& rows, float room) {
  std::size_t longest = 0;  // of the lines that have values; the others may continue below the values
  for (const ListingRow& row : rows)
    if (has_values(row)) longest = std::max(longest, row.text.size());
  ListingColumns columns;
  columns.character = text_width("0");
  columns.code = std::max(px(number_room), 3 * columns.character + px(12));
  const float wanted = columns.code + columns.character * static_cast<float>(longest + 2);
  if (room - wanted >= px(least_values)) columns.values = wanted;
  return columns;
}

/// One line of code with what it had. Answers by how much its loop was stepped.
int draw_row(const ListingRow& row, std::size_t index, const ListingColumns& columns, const LineMarks& marks) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, height = ImGui::GetTextLineHeight();
  const bool valued = has_values(row);
  const bool aside = columns.values > 0 && valued;
  const float code_width = (aside ? columns.values : room) - columns.code;
  const auto signs = static_cast<std::size_t>(std::max(12.f, std::floor(code_width / columns.character)));
  const std::string code = aside ? row.text : code_lines(row.text, signs);
  const float code_height = std::max(height, text_height(code));
  const float code_end = at.x + (columns.values > 0 && valued ? columns.values : room);
  if (valued)
    ImGui::GetWindowDrawList()->AddRectFilled({at.x + columns.code - px(4), at.y}, {code_end, at.y + code_height},
                                              colour_u32(palette().field), px(2));
  if (!row.text.empty()) line_ground(row.number, {code_end - at.x, code_height}, marks);
  draw_text(at, {at.x + columns.code - px(8), at.y + height}, fmt::format("{}", row.number), palette().text_quiet, 1);
  const auto start = row.text.find_first_not_of(' ');
  const bool comment = start != std::string::npos && row.text.compare(start, 2, "//") == 0;
  draw_lines({at.x + columns.code, at.y}, code, comment ? palette().text_quiet : palette().text);
  int by = 0;
  const float indent = columns.character * static_cast<float>((start == std::string::npos ? 0 : start) + 2);
  const float values_at = columns.values > 0 ? columns.values + px(8) : columns.code + indent;
  if (aside) {
    ImGui::SetCursorScreenPos({at.x + values_at, at.y});
  } else {
    ImGui::Dummy({room, code_height});
    if (!valued) return 0;
    const float needed = row.loops ? stepper_width(row) : 0;
    ImGui::SetCursorScreenPos(
        {at.x + std::max(columns.code, std::min(values_at, room - needed)), ImGui::GetCursorScreenPos().y});
  }
  if (row.loops) {
    by = stepper(row, index);
    if (!row.values.empty()) ImGui::SameLine(0, px(14));
  }
  values(row, at.x + (aside ? values_at : columns.code));
  return by;
}

/// Small print where a line would be cut otherwise.
Face code_face(const std::vector<ListingRow>& rows, float room) {
  const FontScope font(Face::mono);
  std::size_t longest = 0;
  for (const ListingRow& row : rows) longest = std::max(longest, row.text.size());
  const float wanted = px(number_room) + text_width("0") * static_cast<float>(longest);
  return wanted <= room ? Face::mono : Face::mono_small;
}

/// A loop whose arrow was clicked.
struct Step {
  std::size_t row = 0;
  int by = 0;
};

/// `reveal`: scrolls to the marked line, else to the first one that has values.
std::optional<Step> code(const std::vector<ListingRow>& rows, bool reveal, const LineMarks& marks) {
  std::optional<Step> step;
  const auto first = std::find_if(rows.begin(), rows.end(), [&](const ListingRow& row) {
    return marks.marked ? row.number == marks.marked->number : has_values(row);
  });
  ImGui::BeginChild("code");
  {
    const FontScope font(code_face(rows, ImGui::GetContentRegionAvail().x));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {px(4), px(1)});
    gui::values().publish("listing/lines",
                          static_cast<int>(ImGui::GetWindowHeight() / ImGui::GetTextLineHeightWithSpacing()));
    const ListingColumns columns = columns_for(rows, ImGui::GetContentRegionAvail().x);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (reveal && first != rows.end() && i == static_cast<std::size_t>(first - rows.begin()))
        ImGui::SetScrollHereY(0.15f);
      if (const int by = draw_row(rows[i], i, columns, marks); by != 0) step = Step{i, by};
      if (marks.marked && rows[i].number == marks.marked->number) right_version(*marks.marked, columns.code);
    }
    ImGui::PopStyleVar();
  }
  ImGui::EndChild();
  return step;
}

}  // namespace

void update_listing(ListingPanelState& state) { state.worker.take_news(); }

bool listing_panel(Session& session, ListingPanelState& state, bool filled) {
  const NameScope scope("listing");
  if (!session.has_scene()) return false;
  // A question about a wrong line is one about the listing of A; that of B is the answer.
  const Side side = state.marks.answer ? Side::a : inspected_side(session);
  const auto pixel = session.pixel();
  if (!pixel) {
    state.worker.clear();
    take_up(state, nullptr, -1);
    quiet_text("Click a pixel to see a lesson's routine with the values that its lines have there.");
    return false;
  }
  StoryRequest request;
  request.picture.scene = session.scene();
  request.picture.view = session.view();
  request.picture.settings = listing_settings(session, side);
  request.pixel = *pixel;
  state.worker.request(request);
  take_up(state, state.worker.story(), session.document().story.listing_instance);
  const bool fill = toolbar(session, state, side, filled);
  if (!state.error.empty()) quiet_text(state.error);
  if (!state.view) {
    if (const auto message = state.worker.message(); !message.empty()) quiet_text(message);
    return fill;
  }
  if (state.shown_story->listing->watches.empty())
    quiet_text("No line of this routine reached the pixel: it draws nothing here.");
  ImGui::Spacing();
  const LineMarks marks = side == Side::a ? state.marks : LineMarks{};
  const auto stepped = code(state.rows, std::exchange(state.reveal, false), marks);
  if (stepped) {
    state.view->step(stepped->row, stepped->by);
    state.instance = state.view->focus();
    state.rows = state.view->rows();
    session.navigate([&](Document& document) { document.story.listing_instance = state.instance; });
  }
  return fill;
}

}  // namespace ps::gui
