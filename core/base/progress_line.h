#pragma once
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "base/progress.h"

namespace ps {

/// Writes how far a long call is into one line of a terminal, over and over, as long as it lives; then the line is
/// empty again. Writes to terminals alone, and only about work of half a second or more.
class ProgressLine {
 public:
  /// `terminal` is a descriptor; `what` stands before the number: "rendering". The progress must outlive this.
  ProgressLine(const Progress& progress, std::string what, int terminal = 2);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

 private:
  void work(const Progress& progress);

  std::string what_;
  int terminal_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool ending_ = false;
  std::thread thread_;  ///< the last member, for it uses the others from its beginning
};

}  // namespace ps
