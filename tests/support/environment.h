#pragma once
#include <cstdlib>
#include <optional>
#include <random>
#include <string>

namespace ps::test {

/// The number in an environment variable, or `otherwise`.
inline double number_from(const char* name, double otherwise) {
  const char* text = std::getenv(name);
  return text != nullptr ? std::strtod(text, nullptr) : otherwise;
}

/// PIXELSCOPE_TEST_SEED, which repeats a run, or `otherwise`.
inline unsigned test_seed(unsigned otherwise = std::random_device{}()) {
  return static_cast<unsigned>(number_from("PIXELSCOPE_TEST_SEED", otherwise));
}

/// An environment variable has this value while it lives.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) {
    if (const char* now = std::getenv(name)) before_ = now;
    setenv(name, value.c_str(), 1);
  }
  ~Variable() {
    if (before_)
      setenv(name_, before_->c_str(), 1);
    else
      unsetenv(name_);
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

/// Programs that start while it lives look for libraries in this folder first.
class FirstLibraryFolder : public Variable {
 public:
  explicit FirstLibraryFolder(const std::string& folder) : Variable("LD_LIBRARY_PATH", folder + rest()) {}

 private:
  static std::string rest() {
    const char* now = std::getenv("LD_LIBRARY_PATH");
    return now && *now ? ":" + std::string(now) : "";
  }
};

/// Programs that start while it lives find no driver of OpenGL. `folder` is an empty one.
struct WithoutEglDriver {
  explicit WithoutEglDriver(const std::string& folder)
      : folders("__EGL_VENDOR_LIBRARY_DIRS", folder), files("__EGL_VENDOR_LIBRARY_FILENAMES", folder + "/none.json") {}
  Variable folders, files;
};

}  // namespace ps::test
