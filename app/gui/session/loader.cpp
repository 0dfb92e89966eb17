#include "gui/session/loader.h"

#include <sstream>
#include <utility>

#include "base/check.h"
#include "base/failure_text.h"
#include "base/foreign_text.h"
#include "base/quoted_line.h"

namespace ps::gui {
namespace {

constexpr std::size_t recent_limit = 10;
constexpr const char* recent_key = "session/recent";

}  // namespace

Loaded failed_load(const std::string& name, const std::exception& error) {
  const auto* input = dynamic_cast<const InputError*>(&error);
  return {.name = name,
          .document = {},
          .error = failure_text(error) + foreign_text(quoted_lines(error)),
          .error_file = input ? input->place().file : ""};
}

Loader::Loader(SessionHost host) : host_(std::move(host)), watch_(host_.wake) {
  if (!host_.remembered) return;
  std::istringstream lines(host_.remembered(recent_key));
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && recent_.size() < recent_limit) recent_.push_back(line);
}

void Loader::load(const std::string& name, std::function<Document()> make, LoadReason reason) {
  name_ = name;
  cancelled_ = false;
  job_.start([this, name, make = std::move(make), reason](Progress& progress) {
    Loaded loaded;
    loaded.name = name;
    loaded.reason = reason;
    try {
      loaded.document = make();
    } catch (const std::exception& error) {
      loaded = failed_load(name, error);
      loaded.reason = reason;
    }
    progress.check();
    {
      const std::lock_guard lock(mutex_);
      loaded_ = std::move(loaded);
    }
    if (host_.wake) host_.wake();
  });
}

void Loader::cancel() {
  cancelled_ = true;
  job_.cancel();
}

bool Loader::has_news() const {
  const std::lock_guard lock(mutex_);
  return loaded_.has_value();
}

std::optional<Loaded> Loader::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(loaded_, std::nullopt);
}

void Loader::note_recent(const std::string& name) {
  std::erase(recent_, name);
  recent_.insert(recent_.begin(), name);
  if (recent_.size() > recent_limit) recent_.resize(recent_limit);
  std::string lines;
  for (const auto& entry : recent_) lines += entry + '\n';
  if (host_.remember_lines) host_.remember_lines(recent_key, lines);
}

}  // namespace ps::gui
