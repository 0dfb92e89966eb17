#include "student/own_listing.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "base/check.h"
#include "base/user_folder.h"

namespace ps {
namespace {

namespace fs = std::filesystem;

constexpr int most_copies = 1000;  // of one listing

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// Writes a file that is not there yet. Answers whether there was none.
bool write_new_file(const fs::path& path, const std::string& text) {
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "wx"));
  if (!file) {
    if (errno == EEXIST) return false;
    throw InputError(fmt::format("{} cannot be written: {}", path.string(), std::strerror(errno)));
  }
  if (std::fwrite(text.data(), 1, text.size(), file.get()) != text.size() || std::fflush(file.get()) != 0) {
    const int reason = errno;
    std::remove(path.c_str());  // half a copy would take the name of a whole one
    throw InputError(fmt::format("{} cannot be written: {}", path.string(), std::strerror(reason)));
  }
  return true;
}

}  // namespace

std::string_view own_rights_sentence() {
  return "This file is compiled and run as a program of yours. Go on only if you know what is in it.";
}

fs::path own_listings_folder() {
  const fs::path folder = user_folder("XDG_DATA_HOME", ".local/share");
  if (folder.empty()) throw InputError("neither XDG_DATA_HOME nor HOME names a folder for your listings");
  return folder / "pixelscope" / "listings";
}

PermittedListing ListingPermits::copy(const NamedListing& listing, std::string_view routine) {
  const fs::path folder = own_listings_folder();
  const std::string text = listing_copy(listing, routine);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(fmt::format("{} cannot be made: {}", folder.string(), error.message()));
  const std::string name = routine.empty() ? listing.folder : fmt::format("{}_{}", listing.folder, routine);
  for (int number = 1; number <= most_copies; ++number) {
    const fs::path file = folder / (number == 1 ? name + ".cpp" : fmt::format("{}_{}.cpp", name, number));
    if (write_new_file(file, text)) return permit(file);
  }
  throw InputError(fmt::format("{} holds {} copies of this listing already", folder.string(), most_copies));
}

PermittedListing ListingPermits::permit(const fs::path& file) {
  std::error_code error;
  const fs::path place = fs::canonical(file, error);
  if (error || !fs::is_regular_file(place, error))
    throw InputError(fmt::format("{} is not a file that can be read", file.string()));
  files_.insert(place);
  return PermittedListing(place);
}

std::optional<PermittedListing> ListingPermits::find(const fs::path& file) const {
  std::error_code error;
  const fs::path place = fs::canonical(file, error);
  if (error || files_.count(place) == 0) return {};
  return PermittedListing(place);
}

}  // namespace ps
