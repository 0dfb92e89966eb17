#pragma once
#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "base/check.h"

namespace ps {

/// A file descriptor of this process, closed with the object. Its number is at least 10, so that it can be given to a
/// child under a small one without overwriting another.
class Descriptor {
 public:
  Descriptor() = default;
  /// Takes over `raw`, which a system call gave.
  explicit Descriptor(int raw) {
    constexpr int smallest = 10;
    if (raw < 0) throw InputError(std::string("a child process cannot be started: ") + std::strerror(errno));
    number_ = fcntl(raw, F_DUPFD_CLOEXEC, smallest);
    const int reason = errno;
    ::close(raw);
    if (number_ < 0) throw InputError(std::string("a child process cannot be started: ") + std::strerror(reason));
  }
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }

  int number() const { return number_; }  ///< -1 = closed
  void close() {
    if (number_ >= 0) ::close(std::exchange(number_, -1));
  }

 private:
  int number_ = -1;
};

/// The two ends of a pipe: what goes into `in` comes out of `out`.
struct Pipe {
  Pipe() {
    std::array<int, 2> ends{-1, -1};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) ends = {-1, -1};
    out = Descriptor(ends[0]);
    in = Descriptor(ends[1]);
    fcntl(out.number(), F_SETFL, O_NONBLOCK);
  }
  Descriptor out, in;
};

/// Two ends that can both be read and written.
struct SocketPair {
  SocketPair() {
    std::array<int, 2> ends{-1, -1};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) ends = {-1, -1};
    ours = Descriptor(ends[0]);
    theirs = Descriptor(ends[1]);
    fcntl(ours.number(), F_SETFL, O_NONBLOCK);
  }
  Descriptor ours, theirs;
};

}  // namespace ps
