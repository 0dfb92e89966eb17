#include "base/progress_line.h"

#include <unistd.h>

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <utility>

namespace ps {
namespace {

void write_text(int terminal, const std::string& text) {
  if (write(terminal, text.data(), text.size()) < 0) return;  // the terminal has gone
}

}  // namespace

ProgressLine::ProgressLine(const Progress& progress, std::string what, int terminal)
    : what_(std::move(what)), terminal_(terminal) {
  if (isatty(terminal)) thread_ = std::thread([this, &progress] { work(progress); });
}

ProgressLine::~ProgressLine() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void ProgressLine::work(const Progress& progress) {
  using namespace std::chrono_literals;
  std::unique_lock lock(mutex_);
  const auto ended = [this] { return ending_; };
  if (changed_.wait_for(lock, 500ms, ended)) return;
  do {
    write_text(terminal_, fmt::format("\r{} {:3.0f} %", what_, std::floor(progress.fraction() * 100)));
  } while (!changed_.wait_for(lock, 200ms, ended));
  write_text(terminal_, fmt::format("\r{:{}}\r", "", what_.size() + 6));
}

}  // namespace ps
