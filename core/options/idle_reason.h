#pragma once
#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace ps {

/// A value of an option under which another one would act.
struct Need {
  std::string_view option;  ///< its key
  double value = 0;         ///< as Option::set takes it
};

/// Why an option, or one of its values, has no effect: another setting is needed, another renderer or listing, or the
/// scene or the machine lacks something. All texts outlive the program's tables.
class IdleReason {
 public:
  enum class Kind {
    missing,  ///< no setting helps
    setting,  ///< one of needs() helps
    renderer  ///< another renderer, or another listing, acts on it
  };

  /// Missing thing: "the scene has no texture". Implicit, so that a row of the option table just returns the words.
  IdleReason(const char* missing) : words_(missing) {}
  IdleReason(std::string_view missing) : words_(missing) {}
  IdleReason(Kind kind, std::string_view words) : kind_(kind), words_(words) {}
  /// Any of these helps; the first is preferred.
  IdleReason(std::initializer_list<Need> needs);

  /// The same with a reason behind the sentence that follows from the needs: "needs multisampling = 1: ...".
  IdleReason because(std::string_view why) const;
  /// The same in other words: "needs a far limit".
  IdleReason said(std::string_view words) const;

  Kind kind() const { return kind_; }
  std::span<const Need> needs() const { return {needs_.data(), count_}; }
  /// "needs shadows = map", or the words.
  std::string text() const;

 private:
  Kind kind_ = Kind::missing;
  std::string_view words_, why_;
  std::array<Need, 3> needs_{};
  std::size_t count_ = 0;
};

/// Why the option needs one of these values of another one: an enum's, or numbers.
template <class... Values>
IdleReason needs(std::string_view option, Values... values) {
  return IdleReason({Need{option, static_cast<double>(values)}...});
}

/// Its words; empty without a reason.
inline std::string text_of(const std::optional<IdleReason>& reason) { return reason ? reason->text() : ""; }

}  // namespace ps
