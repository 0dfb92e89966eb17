#include "support/well_formed.h"

#include <algorithm>
#include <cctype>

namespace ps::test {
namespace {

class MarkupReader {
 public:
  explicit MarkupReader(std::string_view text) : text_(text) {}

  std::string fault() {
    if (starts("<!")) at_ = std::min(text_.find('>'), text_.size() - 1) + 1;
    skip_space();
    element();
    skip_space();
    if (fault_.empty() && at_ != text_.size()) fail("something behind the element");
    return fault_;
  }

 private:
  void fail(const std::string& what) {
    if (fault_.empty()) fault_ = what + " at byte " + std::to_string(at_);
    at_ = text_.size();
  }
  bool starts(std::string_view start) const { return text_.substr(at_, start.size()) == start; }
  void skip_space() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) ++at_;
  }
  /// Of an element or, with hyphens and colons, of an attribute.
  std::string name() {
    const std::size_t begin = at_;
    while (at_ < text_.size() &&
           (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || starts("-") || starts(":")))
      ++at_;
    if (at_ == begin) fail("no name");
    return std::string(text_.substr(begin, at_ - begin));
  }
  void entity() {
    for (const std::string_view known : {"&amp;", "&lt;", "&gt;", "&quot;", "&#160;"})
      if (starts(known)) {
        at_ += known.size();
        return;
      }
    fail("a bare '&'");
  }
  void attribute() {
    name();
    if (!starts("=\"")) return fail("an attribute without a value");
    for (at_ += 2; at_ < text_.size() && text_[at_] != '"';) {
      if (text_[at_] == '<') return fail("'<' in an attribute");
      if (text_[at_] == '&')
        entity();
      else
        ++at_;
    }
    if (at_ >= text_.size()) return fail("an open attribute");
    ++at_;
  }
  /// How many children an element of this name must have; -1: any number.
  static int children_of(const std::string& element_name) {
    if (element_name == "mfrac" || element_name == "mroot" || element_name == "msub" || element_name == "msup" ||
        element_name == "munder" || element_name == "mover")
      return 2;
    return element_name == "msubsup" || element_name == "munderover" ? 3 : -1;
  }
  void element() {
    if (!starts("<")) return fail("no element");
    ++at_;
    const std::string begun = name();
    for (skip_space(); fault_.empty() && at_ < text_.size() && !starts("/") && !starts(">"); skip_space()) attribute();
    if (starts("/>")) {
      at_ += 2;
      return;
    }
    if (!starts(">")) return fail("an open tag");
    ++at_;
    int children = 0;
    while (fault_.empty() && at_ < text_.size() && !starts("</")) {
      if (starts("<")) {
        element();
        ++children;
      } else if (text_[at_] == '&') {
        entity();
      } else {
        ++at_;
      }
    }
    if (!starts("</" + begun + ">")) return fail("'" + begun + "' without its end");
    at_ += begun.size() + 3;
    if (children_of(begun) >= 0 && children != children_of(begun)) fail("wrong number of children of " + begun);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::string fault_;
};

}  // namespace

std::string markup_fault(std::string_view text) { return MarkupReader(text).fault(); }

}  // namespace ps::test
