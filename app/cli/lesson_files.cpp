#include "cli/lesson_files.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "base/atomic_file.h"
#include "base/check.h"
#include "cli/interrupt.h"
#include "cli/lesson_template.h"
#include "cli/output_file.h"
#include "engine/handout.h"
#include "engine/lesson_place.h"

namespace ps::cli {
namespace {

struct HandoutArguments {
  std::string lesson, out;
  bool all = false, teacher = false;
};

int write_all_handouts(const std::filesystem::path& folder, HandoutFor reader) {
  make_folder(folder);
  std::vector<Lesson> lessons;
  for (const std::string& name : lesson_names()) {
    lessons.push_back(load_lesson(name));
    const std::string html = handout_html(lessons.back(), reader, interruptible_progress());
    write_file_atomically(folder / (name + ".html"), html);
    fmt::print("{}\n", (folder / (name + ".html")).string());
  }
  write_file_atomically(folder / "index.html", handout_index(load_course(), lessons));
  return 0;
}

int write_handout(const HandoutArguments& arguments) {
  const HandoutFor reader = arguments.teacher ? HandoutFor::teacher : HandoutFor::student;
  if (arguments.all != arguments.lesson.empty())
    throw InputError("handout: expected the name or folder of a lesson, or --all");
  if (arguments.all) return write_all_handouts(arguments.out, reader);
  const Lesson lesson = load_lesson(arguments.lesson);
  require_output_file(arguments.out, OutputKind::any);
  write_file_atomically(arguments.out, handout_html(lesson, reader, interruptible_progress()));
  return 0;
}

int new_lesson(const std::filesystem::path& folder) {
  for (const char* name : {"lesson.md", "balls.scene"}) {
    std::error_code error;
    if (std::filesystem::exists(folder / name, error))
      throw InputError(fmt::format("{} exists already", (folder / name).string()));
  }
  make_folder(folder);
  write_file_atomically(folder / "lesson.md", lesson_template());
  write_file_atomically(folder / "balls.scene", lesson_template_scene);
  fmt::print("Open it with: pixelscope --lesson {0}\nCheck it with: pixelscope-cli lessons check {0}\n",
             std::filesystem::absolute(folder).lexically_normal().string());
  return 0;
}

}  // namespace

void add_lesson_file_commands(CLI::App& lessons, Action& chosen) {
  CLI::App* handout = lessons.add_subcommand("handout", "a lesson as one HTML file to print or to read offline");
  const auto arguments = std::make_shared<HandoutArguments>();
  handout->add_option("NAME", arguments->lesson, "a lesson, or the folder of one");
  handout->add_flag("--all", arguments->all, "all lessons, with a page that lists them");
  handout->add_flag("--teacher", arguments->teacher, "with notes, measured answers and what comes next");
  handout->add_option("--out", arguments->out, "file to write; with --all a folder")->required();
  handout->callback([&chosen, arguments] { chosen = [arguments] { return write_handout(*arguments); }; });

  CLI::App* made = lessons.add_subcommand("new", "begin a lesson of one's own in a folder");
  const auto folder = std::make_shared<std::string>();
  made->add_option("FOLDER", *folder, "a folder, which is made if need be")->required();
  made->callback([&chosen, folder] { chosen = [folder] { return new_lesson(*folder); }; });
}

}  // namespace ps::cli
