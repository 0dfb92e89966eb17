#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gui/work/file_watch.h"
#include "gui/work/latest_result.h"
#include "gui/work/render_worker.h"
#include "student/check_listing.h"
#include "textbook/listing_view.h"

namespace ps::gui {

/// A picture to be made by a student's own listing.
struct OwnRequest {
  std::optional<PermittedListing> file;
  int opened = 0;        ///< which of the files that were opened it is
  int saves = 0;         ///< how often it has been saved since
  bool stopped = false;  ///< no run until it is saved again
  PictureRequest picture;
  std::optional<Vec2i> pixel;
};
bool same_own_request(const OwnRequest& a, const OwnRequest& b);

/// Its result.
struct OwnOutcome {
  int opened = 0, saves = 0;  ///< of the request
  Compilation compilation;
  std::string failure;                    ///< why there is no picture; empty if there is one
  std::string printed;                    ///< what the program wrote
  const NamedListing* listing = nullptr;  ///< that it is a copy of
  WrongPixels wrong;
  Vec2i size{0, 0};
  int pictures = 0;  ///< how many there were so far; the newest is in the file
  std::string picture_file;
  double seconds = 0;  ///< from the save to the picture
  std::shared_ptr<const OwnTrace> values;
  std::optional<ListingTrace> trace;  ///< of the pixel; its names lie in `values`
};

/// Compiles, runs and compares, on the thread of a worker; keeps the program and what is known of its picture.
class OwnListingMaker {
 public:
  OwnOutcome make(const OwnRequest& request, Progress& progress);

 private:
  void make_picture(const OwnRequest& request, Progress& progress, OwnOutcome& outcome);
  void make_values(const OwnRequest& request, Progress& progress, OwnOutcome& outcome) const;

  int compiled_opened_ = 0, compiled_saves_ = 0;
  std::optional<Compilation> compilation_;
  std::optional<PictureRequest> pictured_;
  OwnOutcome last_;  ///< of `pictured_`
};

/// The routine that the open step of a lesson asks for.
struct WriteTask {
  std::string lesson, routine;  ///< empty = none
};

/// State of the panel of listings for a student's own one. Files that were allowed are known in this run alone.
struct OwnListingState {
  explicit OwnListingState(const std::function<void()>& wake);

  ListingPermits permits;
  WriteTask task;
  std::optional<PermittedListing> file;
  std::filesystem::path asked;  ///< chosen in the dialog, and not confirmed yet
  std::string problem;          ///< why there is no file
  int opened = 0, saves = 0;
  bool stopped = false;
  FileWatch watch;
  std::shared_ptr<OwnListingMaker> maker = std::make_shared<OwnListingMaker>();
  LatestResult<OwnRequest, OwnOutcome> worker;
  std::shared_ptr<const OwnOutcome> taken;
  int pictures = 0;      ///< of those that were put into B's place
  int shown_saves = -1;  ///< of the newest of them
  std::unique_ptr<ListingText> text;
  std::optional<ListingView> view;
  std::vector<ListingRow> rows;
  bool reveal = false;
};

}  // namespace ps::gui
