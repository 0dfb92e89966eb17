#include "base/tar.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <optional>
#include <utility>

#include "base/check.h"
#include "base/spelling.h"

namespace ps {
namespace {

constexpr std::size_t tar_block = 512;
using TarHeader = std::array<char, tar_block>;

/// A field of a header: its first byte and its length.
struct TarField {
  std::size_t at, length;
};
constexpr TarField name_field{0, 100}, mode_field{100, 8}, owner_field{108, 8}, group_field{116, 8},
    size_field{124, 12}, time_field{136, 12}, sum_field{148, 8}, kind_field{156, 1}, magic_field{257, 8},
    prefix_field{345, 155};

void put(TarHeader& header, const TarField& field, std::string_view text) {
  PS_ASSERT(text.size() <= field.length, "text of a tar header fits its field");
  std::copy(text.begin(), text.end(), header.begin() + static_cast<std::ptrdiff_t>(field.at));
}

std::string_view get(std::string_view header, const TarField& field) {
  const std::string_view all = header.substr(field.at, field.length);
  return all.substr(0, all.find('\0'));
}

/// Octal digits up to the field's last byte, which stays 0.
void put_number(TarHeader& header, const TarField& field, std::size_t number) {
  put(header, field, fmt::format("{:0{}o}", number, field.length - 1));
}

std::optional<std::size_t> get_number(std::string_view header, const TarField& field) {
  std::size_t number = 0;
  for (const char c : get(header, field)) {
    if (c == ' ') continue;
    if (c < '0' || c > '7' || number > (std::size_t{1} << 40)) return {};
    number = number * 8 + static_cast<std::size_t>(c - '0');
  }
  return number;
}

/// The sum of all bytes, those of the sum itself taken as blanks.
std::size_t sum_of(std::string_view header) {
  std::size_t sum = 0;
  for (std::size_t i = 0; i < tar_block; ++i) {
    const bool own = i >= sum_field.at && i < sum_field.at + sum_field.length;
    sum += own ? ' ' : static_cast<unsigned char>(header[i]);
  }
  return sum;
}

std::size_t blocks_for(std::size_t bytes) { return (bytes + tar_block - 1) / tar_block * tar_block; }

void append_entry(std::string& archive, std::string_view name, char kind, std::string_view bytes) {
  TarHeader header{};
  put(header, name_field, name.substr(0, name_field.length));
  put_number(header, mode_field, 0644);
  put_number(header, owner_field, 0);
  put_number(header, group_field, 0);
  put_number(header, size_field, bytes.size());
  put_number(header, time_field, 0);
  put(header, kind_field, {&kind, 1});
  put(header, magic_field, std::string_view("ustar\00000", 8));
  put(header, sum_field, fmt::format("{:06o}", sum_of({header.data(), tar_block})));
  header[sum_field.at + 7] = ' ';
  archive.append(header.data(), tar_block);
  archive += bytes;
  archive.append(blocks_for(bytes.size()) - bytes.size(), '\0');
}

/// The path of a pax header, whose records are "LENGTH KEY=VALUE\n"; empty where it gives none.
std::string pax_path(std::string_view records) {
  std::string path;
  while (!records.empty()) {
    std::size_t length = 0;
    const auto number = std::from_chars(records.data(), records.data() + records.size(), length);
    const auto digits = static_cast<std::size_t>(number.ptr - records.data());
    if (number.ec != std::errc() || length < digits + 2 || length > records.size()) break;
    const std::string_view record = records.substr(digits + 1, length - digits - 2);
    if (record.starts_with("path=")) path = record.substr(5);
    records.remove_prefix(length);
  }
  return path;
}

/// Goes through the bytes of an archive, entry by entry.
class TarReader {
 public:
  TarReader(std::string_view bytes, const std::string& archive) : bytes_(bytes), archive_(archive) {}

  std::vector<TarEntry> entries() {
    std::vector<TarEntry> entries;
    while (const auto header = next_header()) {
      const std::string_view content = take_content(*header);
      std::string name = std::exchange(long_name_, {});
      const char kind = (*header)[kind_field.at];
      if (kind == 'L') {
        long_name_ = content.substr(0, content.find('\0'));
      } else if (kind == 'x') {
        long_name_ = pax_path(content);
      } else if (kind == '0' || kind == '\0') {
        if (name.empty()) name = name_in(*header);
        entries.push_back({inner_name(name), std::string(content)});
      } else if (kind != '5' && kind != 'g') {  // folders and remarks
        fail(fmt::format("'{}' is a link or a device, expected files alone", shown_start(name_in(*header))));
      }
    }
    if (entries.empty()) fail("the archive holds no file");
    return entries;
  }

 private:
  [[noreturn]] void fail(const std::string& why) const { throw InputError(fmt::format("{}: {}", archive_, why)); }

  /// nullopt at the archive's end, which is a block of zeros.
  std::optional<std::string_view> next_header() {
    const std::string_view header = bytes_.substr(at_, tar_block);
    if (header.size() < tar_block) fail(at_ == 0 ? "this is not a tar archive" : "the archive is cut off");
    if (header.find_first_not_of('\0') == std::string_view::npos) return {};
    const auto sum = get_number(header, sum_field);
    if (!sum || *sum != sum_of(header) || !header.substr(magic_field.at).starts_with("ustar"))
      fail(at_ == 0 ? "this is not a tar archive" : "the archive is damaged");
    at_ += tar_block;
    return header;
  }

  std::string_view take_content(std::string_view header) {
    const auto size = get_number(header, size_field);
    if (!size) fail("the archive is damaged");
    if (*size > bytes_.size() - at_) fail("the archive is cut off");
    const std::string_view content = bytes_.substr(at_, *size);
    at_ = std::min(bytes_.size(), at_ + blocks_for(*size));
    return content;
  }

  static std::string name_in(std::string_view header) {
    const bool gnu = header.substr(magic_field.at, 6) == "ustar ";  // has other things in the prefix's place
    const std::string_view prefix = gnu ? std::string_view() : get(header, prefix_field);
    return std::string(prefix) + (prefix.empty() ? "" : "/") + std::string(get(header, name_field));
  }

  std::string inner_name(const std::string& name) const {
    const std::filesystem::path path(name);
    const bool inside = !name.empty() && name.find('\0') == std::string::npos && path.is_relative() &&
                        std::find(path.begin(), path.end(), "..") == path.end();
    if (!inside) fail(fmt::format("'{}' leads out of the archive", shown_start(name)));
    return path.lexically_normal().generic_string();
  }

  const std::string_view bytes_;
  const std::string& archive_;
  std::size_t at_ = 0;
  std::string long_name_;  // that an entry of its own gave to the next one
};

}  // namespace

std::string tar_bytes(std::span<const TarEntry> entries) {
  std::string archive;
  for (const TarEntry& entry : entries) {
    if (entry.name.size() > name_field.length) append_entry(archive, "././@LongLink", 'L', entry.name + '\0');
    append_entry(archive, entry.name, '0', entry.bytes);
  }
  return archive.append(2 * tar_block, '\0');
}

std::vector<TarEntry> read_tar(std::string_view bytes, const std::string& archive) {
  return TarReader(bytes, archive).entries();
}

}  // namespace ps
