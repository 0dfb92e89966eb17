#include "gui/frame/file_dialog.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <vector>

#include "document/permalink_file.h"
#include "gui/theme/theme.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

struct Listing {
  std::vector<std::string> folders, files;
};

bool fits(const std::filesystem::path& path, FilePurpose purpose) {
  const std::string extension = path.extension().string();
  switch (purpose) {
  case FilePurpose::open_scene:
    return extension == ".scene" || extension == ".obj" || extension == permalink_extension;
  case FilePurpose::save_picture:
    return extension == ".png" || extension == ".ppm";
  case FilePurpose::save_scene:
    return extension == ".scene";
  case FilePurpose::open_picture:
  case FilePurpose::compare_picture:
    return extension == ".png" || extension == ".ppm" || extension == ".pfm";
  case FilePurpose::save_chart:
    return extension == ".csv" || extension == ".json" || extension == ".svg";
  case FilePurpose::save_permalink:
    return extension == permalink_extension;
  case FilePurpose::save_story:
    return extension == ".md" || extension == ".csv" || extension == ".json";
  case FilePurpose::save_space:
  case FilePurpose::save_microscope:
    return extension == ".svg";
  }
  return false;
}

Listing list(const std::filesystem::path& folder, FilePurpose purpose) {
  Listing found;
  std::error_code error;
  for (auto entry = std::filesystem::directory_iterator(folder, error);
       !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with('.')) continue;
    std::error_code ignored;
    if (entry->is_directory(ignored))
      found.folders.push_back(name);
    else if (fits(entry->path(), purpose))
      found.files.push_back(name);
  }
  std::sort(found.folders.begin(), found.folders.end());
  std::sort(found.files.begin(), found.files.end());
  return found;
}

const char* title_of(FilePurpose purpose) {
  switch (purpose) {
  case FilePurpose::open_scene:
    return "Open a scene";
  case FilePurpose::save_picture:
    return "Save the pictures";
  case FilePurpose::save_scene:
    return "Save the scene";
  case FilePurpose::open_picture:
  case FilePurpose::compare_picture:
    return "Compare with a picture";
  case FilePurpose::save_chart:
    return "Save the chart";
  case FilePurpose::save_permalink:
    return "Save the screen";
  case FilePurpose::save_story:
    return "Save the pixel's story";
  case FilePurpose::save_space:
    return "Save the view from outside";
  case FilePurpose::save_microscope:
    return "Save the microscope's view";
  }
  return "";
}

/// What stands in the empty line.
const char* hint_of(FilePurpose purpose) {
  switch (purpose) {
  case FilePurpose::open_scene:
    return "path or name";
  case FilePurpose::save_picture:
  case FilePurpose::open_picture:
  case FilePurpose::compare_picture:
    return "picture.png";
  case FilePurpose::save_scene:
    return "my.scene";
  case FilePurpose::save_chart:
    return "chart.svg";
  case FilePurpose::save_permalink:
    return "screen.permalink";
  case FilePurpose::save_story:
    return "story.md, .csv or .json";
  case FilePurpose::save_space:
  case FilePurpose::save_microscope:
    return "drawing.svg";
  }
  return "";
}

bool reads(FilePurpose purpose) {
  return purpose == FilePurpose::open_scene || purpose == FilePurpose::open_picture ||
         purpose == FilePurpose::compare_picture;
}

}  // namespace

void FileDialog::ask(FilePurpose purpose, const std::string& suggestion) {
  purpose_ = purpose;
  if (folder_.empty()) {
    std::error_code error;
    folder_ = std::filesystem::current_path(error);
  }
  typed_ = suggestion;
  wanted_ = true;
}

void FileDialog::list_folder(std::optional<Answer>& answer) {
  ImGui::BeginChild("files", {0, px(300)}, true);
  const Listing found = list(folder_, purpose_);
  if (ImGui::Selectable("..", false, ImGuiSelectableFlags_DontClosePopups)) folder_ = folder_.parent_path();
  controls().record("file/up", "..");
  for (const auto& name : found.folders) {
    if (ImGui::Selectable((name + "/").c_str(), false, ImGuiSelectableFlags_DontClosePopups)) folder_ /= name;
    controls().record("file/folder/" + name, name);
  }
  for (const auto& name : found.files) {
    if (ImGui::Selectable(name.c_str(), typed_ == name,
                          ImGuiSelectableFlags_DontClosePopups | ImGuiSelectableFlags_AllowDoubleClick)) {
      typed_ = name;
      if (ImGui::IsMouseDoubleClicked(0)) answer = Answer{purpose_, folder_ / name};
    }
    controls().record("file/name/" + name, name);
  }
  if (found.folders.empty() && found.files.empty())
    ImGui::TextUnformatted(purpose_ == FilePurpose::open_scene ? "No .scene or .obj file here."
                                                               : "Nothing of the kind here.");
  ImGui::EndChild();
}

std::optional<FileDialog::Answer> FileDialog::draw() {
  const char* title = title_of(purpose_);
  const bool opens = std::exchange(wanted_, false);
  if (opens) {
    ImGui::OpenPopup(title);
    ++asked_;
  }
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(px(620), window.x - px(20)), 0});
  if (!ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize)) return {};
  std::optional<Answer> answer;
  ImGui::PushStyleColor(ImGuiCol_Text, palette().text_quiet);
  ImGui::TextWrapped("%s", folder_.string().c_str());
  ImGui::PopStyleColor();
  list_folder(answer);
  std::array<char, 4096> buffer{};
  typed_.copy(buffer.data(), buffer.size() - 1);
  ImGui::SetNextItemWidth(-1);
  if (opens) ImGui::SetKeyboardFocusHere();
  // A line of its own each time: Dear ImGui selects all of a suggestion, so that typing replaces it, only in a new one.
  ImGui::PushID(asked_);
  const bool entered = ImGui::InputTextWithHint("##path", hint_of(purpose_), buffer.data(), buffer.size(),
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::PopID();
  typed_ = buffer.data();
  controls().record("file/path", typed_);
  const std::string nothing = typed_.empty() ? "Choose a file or type its path." : "";
  if (button("file/ok", reads(purpose_) ? "Open" : "Save", Emphasis::primary, {.tooltip = {}, .disabled = nothing}) ||
      (entered && !typed_.empty())) {
    const std::filesystem::path typed(typed_);
    answer = Answer{purpose_, typed.is_absolute() ? typed : folder_ / typed};
  }
  ImGui::SameLine();
  const bool cancelled = button("file/cancel", "Cancel") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  if (answer || cancelled) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  return answer;
}

}  // namespace ps::gui
