// Little-endian numbers into and out of a span of bytes that may be too short. Freestanding.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace breakaway::wire {

/// Writes one after the other; what no longer fits makes it not ok and is left out.
class Writer {
 public:
  explicit Writer(std::span<std::uint8_t> room) : room_(room) {}

  template <typename Number>
  void operator()(const Number& number) {
    if constexpr (std::is_enum_v<Number>) {
      (*this)(static_cast<std::underlying_type_t<Number>>(number));
    } else if constexpr (std::is_same_v<Number, float>) {
      (*this)(std::bit_cast<std::uint32_t>(number));
    } else {
      static_assert(std::is_integral_v<Number>);
      if (room_.size() - used_ < sizeof(Number)) {
        ok_ = false;
        return;
      }
      const auto word = static_cast<std::make_unsigned_t<Number>>(number);
      for (std::size_t k = 0; k < sizeof(Number); ++k) room_[used_++] = static_cast<std::uint8_t>(word >> (8 * k));
    }
  }
  template <typename Number, std::size_t n>
  void operator()(const Number (&numbers)[n]) {
    for (const Number& number : numbers) (*this)(number);
  }
  /// A list of at most n: how many in a byte, then each.
  template <typename Number, std::size_t n>
  void list(std::uint8_t count, const Number (&numbers)[n]) {
    (*this)(count);
    for (std::size_t k = 0; k < count && k < n; ++k) (*this)(numbers[k]);
  }
  template <typename Struct>
  requires requires(const Struct& s, Writer& w) { Struct::pass(s, w); }
  void operator()(const Struct& part) { Struct::pass(part, *this); }

  bool ok() const { return ok_; }
  std::span<std::uint8_t> written() const { return room_.first(used_); }

 private:
  std::span<std::uint8_t> room_;
  std::size_t used_ = 0;
  bool ok_ = true;
};

/// Reads what Writer wrote. When the bytes run out, or a list says more than it may hold, it is not ok and gives zeros.
class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  template <typename Number>
  void operator()(Number& number) {
    if constexpr (std::is_enum_v<Number>) {
      std::underlying_type_t<Number> value{};
      (*this)(value);
      number = static_cast<Number>(value);
    } else if constexpr (std::is_same_v<Number, float>) {
      std::uint32_t word = 0;
      (*this)(word);
      number = std::bit_cast<float>(word);
    } else {
      static_assert(std::is_integral_v<Number>);
      number = 0;
      if (bytes_.size() < sizeof(Number)) {
        ok_ = false;
        return;
      }
      std::make_unsigned_t<Number> word = 0;
      for (std::size_t k = 0; k < sizeof(Number); ++k)
        word = static_cast<std::make_unsigned_t<Number>>(word | static_cast<std::uint64_t>(bytes_[k]) << (8 * k));
      number = static_cast<Number>(word);
      bytes_ = bytes_.subspan(sizeof(Number));
    }
  }
  template <typename Number, std::size_t n>
  void operator()(Number (&numbers)[n]) {
    for (Number& number : numbers) (*this)(number);
  }
  template <typename Number, std::size_t n>
  void list(std::uint8_t& count, Number (&numbers)[n]) {
    (*this)(count);
    if (count > n) {
      ok_ = false;
      count = 0;
    }
    for (std::size_t k = 0; k < count; ++k) (*this)(numbers[k]);
  }
  template <typename Struct>
  requires requires(Struct& s, Reader& r) { Struct::pass(s, r); }
  void operator()(Struct& part) { Struct::pass(part, *this); }

  bool ok() const { return ok_; }
  /// What has not been read.
  std::span<const std::uint8_t> rest() const { return bytes_; }

 private:
  std::span<const std::uint8_t> bytes_;
  bool ok_ = true;
};

}  // namespace breakaway::wire
