// The story as Markdown and as comma-separated values.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "base/number_text.h"
#include "inspect/story_markdown.h"
#include "record/event_fields.h"
#include "scene/load.h"
#include "support/read_csv.h"
#include "support/render_once.h"
#include "support/stories.h"

namespace ps::story_files_test {
namespace {

TEST(StoryFiles, CsvKeepsEveryDigit) {
  const Scene scene = load_scene("cgfs/reflections");
  const View view{scene.camera, 200, 200};
  const PixelStory story = inspect(scene, view, {}, {151, 191});
  const auto rows = test::read_csv(story_csv(story, scene, provenance_of(Settings{})));
  ASSERT_GT(rows.size(), story.events.size());
  for (const auto& row : rows) ASSERT_EQ(row.size(), 6u);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"part", "index", "parent", "kind", "name", "value"}));
  std::map<std::string, std::string> values;  // by part, index and name
  for (const auto& row : rows) values[row[0] + "/" + row[1] + "/" + row[4]] = row[5];
  std::size_t hits = 0;
  for (std::size_t i = 0; i < story.events.size(); ++i) {
    const std::string event = "event/" + std::to_string(i) + "/";
    EXPECT_FALSE(values[event + "text"].empty());
    const auto* hit = std::get_if<HitEvent>(&story.events[i].data);
    if (!hit) continue;
    ++hits;
    EXPECT_EQ(parse_number(values[event + "t"]), hit->t);
    EXPECT_EQ(parse_number(values[event + "point[2]"]), hit->point.z);
  }
  EXPECT_GT(hits, 1u);
  double red = 0;
  for (std::size_t i = 0; i < story.ledger.size(); ++i) {
    const std::string line = "ledger/" + std::to_string(i) + "/";
    if (values[line + "level"] == "0") red += *parse_number(values[line + "value[0]"]);
    EXPECT_EQ(values[line + "term"], story.ledger[i].term);
  }
  EXPECT_EQ(red, story.linear.x);
}

TEST(StoryFiles, MarkdownNamesTheRenderer) {
  const Scene scene = test::book_spheres();
  const std::string_view names[] = {"ray tracer", "rasterizer", "textbook listing"};
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer, Renderer::textbook}) {
    PixelStory story = test::mirrored_story();
    story.renderer = renderer;
    const std::string page = story_markdown(story, scene, {scene.camera, 600, 600}, provenance_of(Settings{}));
    const std::string line = "- renderer: " + std::string(names[static_cast<std::size_t>(renderer)]) + "\n";
    EXPECT_NE(page.find(line), std::string::npos) << page;
  }
}

TEST(StoryFiles, MarkdownShowsEverything) {
  const Scene scene = test::book_spheres();
  const PixelStory story = test::mirrored_story();
  const std::string page = story_markdown(story, scene, {scene.camera, 600, 600}, provenance_of(Settings{}));
  const auto lines_with = [&](const std::string& start) {
    std::size_t count = 0;
    for (std::size_t at = 0; at < page.size();) {
      const std::size_t end = std::min(page.find('\n', at), page.size());
      const std::string line = page.substr(at, end - at);
      if (line.substr(std::min(line.find_first_not_of(' '), line.size())).starts_with(start)) ++count;
      at = end + 1;
    }
    return count;
  };
  EXPECT_EQ(page.substr(0, 2), "# ");
  EXPECT_NE(page.find(story.verdict.substr(0, 8)), std::string::npos);
  constexpr std::size_t picture_lines = 4, provenance_lines = 4;  // no settings differ from the defaults
  EXPECT_EQ(lines_with("- "),
            2 * story.events.size() + picture_lines + provenance_lines + (story.triangles_elsewhere > 0 ? 1 : 0))
      << "each event has a sentence and a list of its fields";
  EXPECT_EQ(lines_with("- **"), story.events.size());
  EXPECT_GE(lines_with("| "), story.ledger.size() + 2);
  EXPECT_EQ(std::count(page.begin(), page.end(), '<'), 4) << "details and summary, and nothing of the scene";
  EXPECT_EQ(lines_with("<details>"), 1u);
  EXPECT_EQ(lines_with("</details>"), 1u);
}

}  // namespace
}  // namespace ps::story_files_test
