#include "fuzz/mutate.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace ps::fuzz {
namespace {

/// Values that lie on borders, as text and as bytes.
constexpr std::array<std::string_view, 40> words{"0",           "-1",
                                                 "1",           "2",
                                                 "-2147483648", "2147483647",
                                                 "2147483648",  "4294967295",
                                                 "99999999999", "1e400",
                                                 "nan",         "inf",
                                                 "1e-400",      "0.5",
                                                 "1e12",        "-0",
                                                 "+",           "/",
                                                 "//",          "\\\n",
                                                 "\r",          "\n",
                                                 "\t",          "#",
                                                 "{",           "}",
                                                 "(",           ")",
                                                 "=",           ",",
                                                 "<",           ">",
                                                 "\"",          "\xEF\xBB\xBF",
                                                 "\xFF\xFE",    "-type sphere",
                                                 "off",         "f 1 2 3\n",
                                                 "usemtl a\n",  "include = a.scene\n"};
constexpr std::array<unsigned char, 9> bytes_on_borders{0, 1, 0x7f, 0x80, 0xff, 0x20, 0x0a, 0x40, 0xfe};

class Mutation {
 public:
  Mutation(std::string bytes, const std::vector<std::string>& files, std::mt19937_64& random)
      : bytes_(std::move(bytes)), files_(files), random_(random) {}

  std::string run() {
    for (std::size_t change = 1 + below(8); change > 0; --change) step();
    return std::move(bytes_);
  }

 private:
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }
  std::size_t place() { return below(bytes_.size() + 1); }
  std::size_t length_from(std::size_t at) {
    return std::min(1 + below(std::size_t{1} << below(8)), bytes_.size() - at);
  }

  void step() {
    if (bytes_.empty()) {
      bytes_ = words[below(words.size())];
      return;
    }
    const std::size_t at = below(bytes_.size());
    switch (below(9)) {
    case 0:
      bytes_[at] = static_cast<char>(bytes_[at] ^ (1 << below(8)));
      break;
    case 1:
      bytes_[at] = static_cast<char>(bytes_on_borders[below(bytes_on_borders.size())]);
      break;
    case 2:
      bytes_.erase(at, length_from(at));
      break;
    case 3: {  // a piece once more, somewhere
      const std::string piece = bytes_.substr(at, length_from(at));
      bytes_.insert(place(), piece);
      break;
    }
    case 4:
      bytes_.insert(at, words[below(words.size())]);
      break;
    case 5:
      replace_word(at);
      break;
    case 6: {  // a piece of another file
      const std::string& other = files_[below(files_.size())];
      if (other.empty()) break;
      const std::size_t from = below(other.size());
      bytes_.replace(at, length_from(at), other, from, 1 + below(std::size_t{1} << below(10)));
      break;
    }
    case 7:
      if (below(4) == 0) bytes_.resize(at);
      break;
    case 8:
      bytes_[at] = static_cast<char>(below(256));
      break;
    }
    constexpr std::size_t largest = 1 << 16;
    if (bytes_.size() > largest) bytes_.resize(largest);
  }

  /// The word around a place becomes one from the list.
  void replace_word(std::size_t at) {
    constexpr std::string_view gaps = " \t\r\n(){}=,/";
    std::size_t begin = at, end = at;
    while (begin > 0 && gaps.find(bytes_[begin - 1]) == std::string_view::npos) --begin;
    while (end < bytes_.size() && gaps.find(bytes_[end]) == std::string_view::npos) ++end;
    bytes_.replace(begin, end - begin, words[below(words.size())]);
  }

  std::string bytes_;
  const std::vector<std::string>& files_;
  std::mt19937_64& random_;
};

}  // namespace

std::string mutated(const std::string& bytes, const std::vector<std::string>& files, std::mt19937_64& random) {
  return Mutation(bytes, files, random).run();
}

}  // namespace ps::fuzz
