#include "gui/panels/story/predict_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/screen_names.h"
#include "gui/base/region_names.h"
#include "gui/widgets/draw.h"
#include "render/story/names.h"

namespace ps::gui {
namespace {

constexpr std::array questions{
    Choice{"colour", "Colour", "Red, green and blue of the pixel, 0 to 255."},
    Choice{"winner", "Winner", "The object that the pixel shows."},
    Choice{"rays", "Rays", "Number of rays traced for the pixel: eye, shadow, reflected, refracted."},
    Choice{"triangle", "Triangle", "The triangle that the pixel shows."},
    Choice{"tests", "Tests", "Number of intersections with spheres, triangles and solids tested for the pixel."}};

void ask_colour(Guess& guess) {
  static constexpr std::array names{"red", "green", "blue"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    double level = guess.colour[i];
    show_text(names[i]);
    ImGui::SameLine(px(64));
    if (number(names[i], level, {.minimum = 0, .maximum = 255, .integer = true}, {.width = px(120)}).changed)
      guess.colour[i] = static_cast<int>(level);
  }
  swatch(guess.colour, {px(184), ImGui::GetFrameHeight() * 1.5f});
}

constexpr Choice nothing_chosen{"none", "choose ...", ""}, background{"background", "the background", ""};

/// A list without an answer until one is picked.
bool ask_one_of(const char* name, const std::vector<Choice>& choices, int& index) {
  const int before = index;
  drop_down(name, choices, index, std::min(px(260), ImGui::GetContentRegionAvail().x), {});
  index = index == 0 ? before : index;
  return index != before;
}

void ask_winner(const Scene& scene, PredictState& state) {
  std::vector<Choice> choices{nothing_chosen, background};
  for (const Object& object : scene.geometry->objects) choices.push_back({object.name, object.name, ""});
  int index = state.chosen ? state.guess.object + 2 : 0;
  if (!ask_one_of("object", choices, index)) return;
  state.guess.object = index - 2;
  state.chosen = true;
}

void ask_triangle(const Scene& scene, PredictState& state) {
  const std::vector<PixelId> ids = askable_triangles(scene);
  std::vector<std::string> names, keys;
  for (const PixelId& id : ids) {
    names.push_back(primitive_name(scene, id));
    keys.push_back(fmt::format("{}-{}", id.object, id.triangle));
  }
  std::vector<Choice> choices{nothing_chosen, background};
  for (std::size_t i = 0; i < ids.size(); ++i) choices.push_back({keys[i], names[i], ""});
  const auto said = std::find(ids.begin(), ids.end(), PixelId{state.guess.object, state.guess.triangle});
  int index = !state.chosen ? 0 : said == ids.end() ? 1 : static_cast<int>(said - ids.begin()) + 2;
  if (!ask_one_of("triangle", choices, index)) return;
  const PixelId id = index < 2 ? PixelId{-1, -1} : ids[static_cast<std::size_t>(index - 2)];
  state.guess.object = id.object;
  state.guess.triangle = id.triangle;
  state.chosen = true;
}

/// How many: `what` names the field and is its unit.
void ask_count(const char* what, int& count, double maximum) {
  double value = count;
  if (number(what, value, {.minimum = 0, .maximum = maximum, .integer = true, .unit = what}, {.width = px(160)})
          .changed)
    count = static_cast<int>(value);
}

const char* sentence_of(Question question) {
  switch (question) {
  case Question::colour:
    return "Which colour does this pixel have?";
  case Question::winner:
    return "Which object does this pixel show?";
  case Question::rays:
    return "How many rays were traced for this pixel?";
  case Question::triangle:
    return "Which triangle does this pixel show?";
  case Question::tests:
    return "How many intersections were tested for this pixel?";
  }
  return "";
}

/// The open lesson's question, if its step asks one about its pixel.
void take_up_lesson(Session& session, PredictState& state) {
  if (!state.lesson->follow(session)) return;
  state.words.clear();
  const LessonQuestion* question = state.lesson->question();
  if (!question || question->kind != AskKind::pixel) return;
  state.question = question->about;
  state.words = question->text;
  state.asked_pixel = session.document().pixel;
  state.asked_settings = session.settings(session.document().picked);
  state.answered = false;
  state.guess = {};
  state.chosen = false;
}

/// Whether the lesson asks for something that the story would answer, but not about the pixel.
bool asks_otherwise(const Session& session, const PredictState& state) {
  if (!state.lesson->asked_beside_text(session)) return false;
  const AskKind kind = state.lesson->question()->kind;
  return kind != AskKind::pixel && kind != AskKind::bug;
}

/// Whether a question that no lesson asks has a place in the window: that of the pixel's story, or beside a lesson.
bool has_place(const Document& document) {
  const Layout& layout = document.layout;
  const bool alone = !layout.filled.empty();
  switch (document.mode) {
  case ScreenMode::explore:
    return alone ? layout.filled == region_names::right : layout.panels && layout.story_open;
  case ScreenMode::lesson:
  case ScreenMode::study:
    return !document.lesson.empty() && layout.panels && (!alone || layout.filled == region_names::lesson);
  case ScreenMode::presenter:
    return false;
  }
  return false;
}

/// A lesson whose step is not about the story has it folded.
void unfold_story(Session& session) {
  if (session.document().mode != ScreenMode::lesson || !session.document().layout.stage.empty()) return;
  session.navigate([](Document& document) { document.layout.stage = story_names::one; });
}

/// The story helps to find a wrong line.
bool asks_for_line(const Session& session, const PredictState& state) {
  return state.lesson->asked_beside_text(session) && state.lesson->question()->kind == AskKind::bug;
}

}  // namespace

bool prediction_pending(Session& session, PredictState& state) {
  take_up_lesson(session, state);
  if (asks_otherwise(session, state)) return true;
  if (asks_for_line(session, state)) return false;
  const auto pixel = session.pixel();
  if (!pixel) return false;
  const Settings& settings = session.settings(inspected_side(session));
  // Until the lesson's question is answered, no other takes its place.
  const bool lesson_asks = !state.words.empty() && state.lesson->open();
  if (state.on && !lesson_asks && (state.asked_pixel != *pixel || state.asked_settings != settings)) {
    state.asked_pixel = *pixel;
    state.asked_settings = settings;
    state.answered = false;
    state.words.clear();
    state.guess = {};
    state.chosen = false;
  }
  if (state.asked_pixel != *pixel || state.asked_settings != settings) return false;
  return lesson_asks || (state.on && state.words.empty() && !state.answered && has_place(session.document()));
}

void ask_about_pixels(Session& session, PredictState& state) {
  state.on = true;
  state.asked_pixel = {-1, -1};
  if (has_place(session.document())) return;
  session.navigate([](Document& document) {
    document.mode = ScreenMode::explore;
    document.layout.panels = document.layout.story_open = true;
    document.layout.filled.clear();
  });
}

bool asks_about_pixel(const Session& session, const PredictState& state) {
  return state.on || !asks_otherwise(session, state);
}

void predict_panel(Session& session, PredictState& state) {
  const NameScope scope("predict");
  const Side side = inspected_side(session);
  const auto pixel = session.pixel();
  if (!pixel) return;
  const auto story = session.story(side);
  value_paragraph("question", state.words.empty() ? sentence_of(state.question) : state.words, {Face::bold});
  value_text("about", fmt::format("pixel ({}, {}) of {}", pixel->x, pixel->y, letter_of(side)));
  ImGui::Spacing();
  if (state.words.empty()) {
    if (choice_of("ask", questions, state.question)) state.chosen = false;
    ImGui::Spacing();
  }
  switch (state.question) {
  case Question::colour:
    ask_colour(state.guess);
    break;
  case Question::winner:
    ask_winner(session.scene(), state);
    break;
  case Question::triangle:
    ask_triangle(session.scene(), state);
    break;
  case Question::rays:
    ask_count("rays", state.guess.rays, 100000);
    break;
  case Question::tests:
    ask_count("tests", state.guess.tests, 1e9);
    break;
  }
  ImGui::Spacing();
  const bool ready = story && story->pixel == *pixel && !session.work().inspector(side).busy();
  const auto senseless = ready ? not_askable(state.question, *story) : std::nullopt;
  const bool from_list = state.question == Question::winner || state.question == Question::triangle;
  const bool open = from_list && !state.chosen;
  if (button("answer", "Answer", Emphasis::primary,
             {
                 .tooltip = "Shows whether the answer is right, then the pixel's story.",
                 .disabled = senseless ? *senseless
                                       : std::string_view(!ready ? "The story is being prepared."
                                                          : open ? "Choose an answer first."
                                                                 : ""),
             }) &&
      state.lesson->place.settled()) {
    state.judgement = judge(state.question, state.guess, *story, session.scene());
    state.answered = true;
    if (!state.words.empty())
      state.lesson->take(session, guess_text(state.question, state.guess, session.scene()), state.judgement);
    else
      unfold_story(session);
    ++state.asked;
    state.points += state.judgement.points;
  }
  ImGui::SameLine();
  const bool of_lesson = !state.words.empty();
  if (button("skip", of_lesson ? "Skip" : "Show me", Emphasis::quiet,
             {.tooltip = "Shows the story without an answer; no points."}) &&
      state.lesson->place.settled()) {
    state.judgement = {};
    state.answered = true;
    if (!state.words.empty())
      state.lesson->take(session, "", {});
    else
      unfold_story(session);
  }
  if (state.on) {
    same_line_if_room(button_width("Stop asking"));
    if (button("stop", "Stop asking", Emphasis::quiet)) state.on = false;
  }
}

void prediction_verdict(Session& session, PredictState& state) {
  const NameScope scope("predict");
  if (state.lesson->verdict() || !state.answered || session.pixel() != state.asked_pixel ||
      state.judgement.sentence.empty())
    return;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::Indent(px(16));
  value_paragraph("verdict", state.judgement.sentence, {Face::bold});
  verdict_bar(at, state.judgement);
  ImGui::Unindent(px(16));
  value_text("score",
             fmt::format("{:.3g} of {} point{} so far", state.points, state.asked, state.asked == 1 ? "" : "s"));
  ImGui::Separator();
}

}  // namespace ps::gui
