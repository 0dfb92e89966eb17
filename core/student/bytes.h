#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/check.h"

/// Values as bytes, in this machine's order: for two programs of one build that run on the same machine. Writer and
/// reader have the same words, so that the fields of a scene are listed once (student/scene_fields.h).

namespace ps {

/// Appends values to a text of bytes.
class ByteWriter {
 public:
  template <class Value>
  void value(const Value& value) {
    put_all(&value, 1);
  }
  /// Its length, then its characters.
  void text(std::string_view text) {
    value(static_cast<std::uint32_t>(text.size()));
    bytes_.append(text);
  }
  /// Its length, then its values.
  template <class Value>
  void list(const std::vector<Value>& values) {
    value(static_cast<std::uint64_t>(values.size()));
    put_all(values.data(), values.size());
  }
  /// Its length, then the fields of each.
  template <class List, class Fields>
  void each(const List& list, Fields fields) {
    value(static_cast<std::uint64_t>(list.size()));
    for (const auto& one : list) fields(*this, one);
  }
  /// `count` values that lie behind each other, without their number.
  template <class Value>
  void put_all(const Value* first, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<Value>);
    if (count > 0) bytes_.append(reinterpret_cast<const char*>(first), count * sizeof(Value));
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Reads them again. Whatever the bytes are, it never reads beyond them, and asks for no memory that they do not fill:
/// too few of them are an InputError.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <class Value>
  void value(Value& value) {
    get_all(&value, 1);
  }
  void text(std::string& text) { text = get_text(left()); }
  template <class Value>
  void list(std::vector<Value>& values) {
    const auto count = static_cast<std::size_t>(get<std::uint64_t>());
    require(count, sizeof(Value));
    values.resize(count);
    get_all(values.data(), count);
  }
  template <class List, class Fields>
  void each(List& list, Fields fields) {
    for (auto left = get<std::uint64_t>(); left > 0; --left) fields(*this, list.emplace_back());
  }
  template <class Value>
  Value get() {
    static_assert(std::is_trivially_copyable_v<Value>);
    Value value;
    get_all(&value, 1);
    return value;
  }
  /// At most `longest` bytes long.
  std::string get_text(std::size_t longest) {
    const auto size = get<std::uint32_t>();
    if (size > longest || size > left())
      throw InputError("found a text that is too long, expected the rest of the data");
    std::string text(bytes_.substr(at_, size));
    at_ += size;
    return text;
  }
  template <class Value>
  void get_all(Value* first, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<Value>);
    require(count, sizeof(Value));
    if (count == 0) return;
    std::memcpy(static_cast<void*>(first), bytes_.data() + at_, count * sizeof(Value));
    at_ += count * sizeof(Value);
  }
  /// Throws unless `count` values of that size are still there; before memory for them is asked for.
  void require(std::size_t count, std::size_t size) const {
    if (size > 0 && count > left() / size) throw InputError("found the end of the data, expected more of it");
  }
  std::size_t left() const { return bytes_.size() - at_; }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace ps
