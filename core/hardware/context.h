#pragma once
#include <memory>
#include <string>

#include "base/check.h"
#include "hardware/driver.h"

namespace ps::hardware {

/// Which of the two interfaces: their shaders differ in their first lines.
enum class Api { desktop, embedded };

/// A context is gone with all that it held: with its display, or after a reset of the graphics processor.
class ContextLost : public InputError {
 public:
  ContextLost() : InputError("the graphics driver has lost its context; the next picture starts a new one") {}
};

/// A context of OpenGL 3.3 core or OpenGL ES 3.0 that needs no window and no display. Belongs to the thread that made
/// it.
class Context {
 public:
  /// Tries each device of the machine, then Mesa without a surface, then the default display, and makes the context
  /// current. Throws InputError with the reason where none gives such a context.
  explicit Context(Api api);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  const Driver& driver() const { return driver_; }
  Api api() const { return api_; }
  /// Throws ContextLost.
  void make_current() const;
  /// Ends its display, as a system may at any time: the context is lost from then on. For tests.
  void lose() const;

 private:
  struct Handles;
  Api api_;
  std::unique_ptr<Handles> handles_;
  Driver driver_;
};

/// Takes back what calls before have left for check_gl().
void forget_errors();

/// Throws InputError if a call of OpenGL before has failed, ContextLost if that was why; `what` says what was going on.
void check_gl(const char* what);

}  // namespace ps::hardware
