#include "gui/panels/story/own_listing.h"

#include <fmt/format.h>

#include "base/timer.h"
#include "base/user_folder.h"

namespace ps::gui {
namespace {

/// Where the picture of a student's listing is put: a file that can be lost.
std::filesystem::path own_picture_file(const std::filesystem::path& listing) {
  std::filesystem::path folder = user_folder("XDG_CACHE_HOME", ".cache");
  if (folder.empty()) folder = std::filesystem::temp_directory_path();
  folder /= "pixelscope";
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(fmt::format("{} cannot be made: {}", folder.string(), error.message()));
  return folder / (listing.stem().string() + ".png");
}

}  // namespace

bool same_own_request(const OwnRequest& a, const OwnRequest& b) {
  if (a.opened != b.opened || a.saves != b.saves || a.stopped != b.stopped) return false;
  return a.file.has_value() == b.file.has_value() && a.pixel == b.pixel && same_render(a.picture, b.picture);
}

void OwnListingMaker::make_picture(const OwnRequest& request, Progress& progress, OwnOutcome& outcome) {
  const PictureRequest& picture = request.picture;
  const CheckedListing checked = check_listing(*compilation_->program, *outcome.listing, picture.scene, picture.view,
                                               picture.settings, request.pixel, progress);
  outcome.printed = checked.run.text;
  outcome.failure = checked.run.failure;
  outcome.size = {picture.view.width, picture.view.height};
  if (outcome.failure.empty()) {
    outcome.wrong = checked.wrong;
    outcome.picture_file = own_picture_file(request.file->file()).string();
    save_own_picture(outcome.picture_file, checked.run.result.picture, picture.settings);
    outcome.pictures = last_.pictures + 1;
  }
  if (checked.run.result.trace) outcome.values = std::make_shared<const OwnTrace>(*checked.run.result.trace);
}

void OwnListingMaker::make_values(const OwnRequest& request, Progress& progress, OwnOutcome& outcome) const {
  const PictureRequest& picture = request.picture;
  const BookScene book =
      book_scene(picture.scene, picture.view, settings_of_listing(*outcome.listing, picture.settings));
  const OwnRun run =
      run_listing(*compilation_->program, book, {.picture = false, .traced = request.pixel}, {}, &progress);
  if (run.result.trace) outcome.values = std::make_shared<const OwnTrace>(*run.result.trace);
}

OwnOutcome OwnListingMaker::make(const OwnRequest& request, Progress& progress) {
  const Timer timer;
  OwnOutcome outcome;
  outcome.pictures = last_.pictures;
  outcome.opened = request.opened;
  outcome.saves = request.saves;
  if (compiled_opened_ != request.opened || compiled_saves_ != request.saves) {
    compilation_.reset();
    pictured_.reset();
    compiled_opened_ = request.opened;
    compiled_saves_ = request.saves;
  }
  if (request.stopped || !request.file) {
    outcome.failure = "Stopped. It runs again when the file is saved.";
    if (compilation_) outcome.compilation = *compilation_;
    return outcome;
  }
  try {
    if (!compilation_) compilation_ = compile_listing(*request.file, {}, &progress);
    outcome.compilation = *compilation_;
    outcome.failure = compilation_->failure;
    outcome.listing = copied_listing(compilation_->source);
    if (!compilation_->program) return outcome;
    if (!outcome.listing) {
      outcome.failure = "It does not say which listing it is a copy of: a line such as '// Listing: cgfs_06_lines' is "
                        "missing at its top.";
      return outcome;
    }
    if (!pictured_ || !same_render(*pictured_, request.picture)) {
      make_picture(request, progress, outcome);
      outcome.seconds = timer.milliseconds() / 1000;
      pictured_ = request.picture;
      last_ = outcome;
    } else {
      outcome = last_;
      outcome.values.reset();
      if (outcome.failure.empty() && request.pixel) make_values(request, progress, outcome);
    }
    if (outcome.values && request.pixel)
      outcome.trace = listing_trace(*outcome.values, *outcome.listing, *request.pixel);
  } catch (const InputError& error) {
    outcome.failure = error.what();
  }
  return outcome;
}

OwnListingState::OwnListingState(const std::function<void()>& wake)
    : watch(wake),
      worker([made = maker](const OwnRequest& request, Progress& progress) { return made->make(request, progress); },
             same_own_request, wake, [](const OwnRequest& a, const OwnRequest& b) { return !same_own_request(a, b); }) {
}

}  // namespace ps::gui
