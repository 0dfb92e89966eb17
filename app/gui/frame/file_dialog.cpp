#include "gui/frame/file_dialog.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "gui/platform/imgui_version.h"
#include "gui/theme/theme.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

struct Listing {
  std::vector<std::string> folders, files;
};

Listing list(const std::filesystem::path& folder, const std::vector<std::string>& extensions) {
  Listing found;
  std::error_code error;
  for (auto entry = std::filesystem::directory_iterator(folder, error);
       !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with('.')) continue;
    std::error_code ignored;
    if (entry->is_directory(ignored))
      found.folders.push_back(name);
    else if (std::find(extensions.begin(), extensions.end(), entry->path().extension().string()) != extensions.end())
      found.files.push_back(name);
  }
  std::sort(found.folders.begin(), found.folders.end());
  std::sort(found.files.begin(), found.files.end());
  return found;
}

}  // namespace

FileDialog::FileDialog() {
  std::error_code error;
  folder_ = std::filesystem::current_path(error);
}

void FileDialog::keep_folder(const std::filesystem::path& folder, std::function<void(const std::string&)> keep) {
  go_to(folder);
  keep_ = std::move(keep);
}

void FileDialog::go_to(const std::filesystem::path& folder) {
  std::error_code error;
  if (std::filesystem::is_directory(folder, error)) folder_ = folder;
}

void FileDialog::ask(FileQuestion question) {
  question_ = std::move(question);
  typed_ = question_.suggestion;
  wanted_ = true;
}

void FileDialog::list_folder(std::optional<std::filesystem::path>& chosen) {
  ImGui::BeginChild("files", {0, px(300)}, true);
  const Listing found = list(folder_, question_.extensions);
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
      if (ImGui::IsMouseDoubleClicked(0)) chosen = folder_ / name;
    }
    controls().record("file/name/" + name, name);
  }
  if (found.folders.empty() && found.files.empty())
    show_text(fmt::format("No file here ends in {}.", fmt::join(question_.extensions, ", ")));
  ImGui::EndChild();
}

void FileDialog::draw() {
  const char* title = question_.title.c_str();
  const bool opens = std::exchange(wanted_, false);
  if (opens) {
    ImGui::OpenPopup(title);
    ++asked_;
  }
  if (question_.title.empty()) return;  // no question was asked yet
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(px(620), window.x - px(20)), 0});
  if (!ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize)) return;
  std::optional<std::filesystem::path> chosen;
  quiet_text(folder_.string());
  list_folder(chosen);
  ImGui::SetNextItemWidth(-1);
  if (opens) ImGui::SetKeyboardFocusHere();
  // A line of its own each time: Dear ImGui selects all of a suggestion, so that typing replaces it, only in a new one.
  ImGui::PushID(asked_);
  forget_edits_before("##path");
  const bool entered =
      ImGui::InputTextWithHint("##path", question_.hint.c_str(), &typed_, ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::PopID();
  controls().record("file/path", typed_);
  const std::string nothing = typed_.empty() ? "Choose a file or type its path." : "";
  if (button("file/ok", question_.use == FileUse::open ? "Open" : "Save", Emphasis::primary, {.disabled = nothing}) ||
      (entered && !typed_.empty())) {
    const std::filesystem::path typed(typed_);
    chosen = typed.is_absolute() ? typed : folder_ / typed;
  }
  ImGui::SameLine();
  const bool cancelled = button("file/cancel", "Cancel") || key_pressed(Key::escape);
  if (chosen || cancelled) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  if (!chosen) return;
  go_to(chosen->parent_path());
  if (keep_) keep_(folder_.string());
  const FileQuestion asked = question_;  // the answer may ask again
  asked.answer({*chosen, typed_});
}

}  // namespace ps::gui
