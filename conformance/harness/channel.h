// Values over a pipe between two programs of this suite on one machine: raw memory, no byte order, no versions.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "conformance/harness/picture.h"

namespace gouraud::conformance {

/// The other side ended, or said nothing for too long.
struct ChannelClosed : std::runtime_error {
  using std::runtime_error::runtime_error;
};
struct ChannelTimeout : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Writer {
 public:
  explicit Writer(int fd) : fd_(fd) {}
  void bytes(const void* data, std::size_t size);
  template <class T>
    requires std::is_trivially_copyable_v<T>
  void value(const T& value) {
    bytes(&value, sizeof(value));
  }
  template <class T>
  void array(const std::vector<T>& values) {
    value(static_cast<std::uint64_t>(values.size()));
    bytes(values.data(), values.size() * sizeof(T));
  }
  void text(std::string_view text);
  void picture(const Picture& picture);

 private:
  void exact_picture(const oracle::OraclePicture& exact);

  int fd_;
};

class Reader {
 public:
  /// Any single read that waits longer than `timeout_s` throws ChannelTimeout.
  Reader(int fd, int timeout_s) : fd_(fd), timeout_s_(timeout_s) {}
  void bytes(void* data, std::size_t size);
  template <class T>
  T value() {
    T result;
    bytes(&result, sizeof(result));
    return result;
  }
  template <class T>
  std::vector<T> array() {
    std::vector<T> result(value<std::uint64_t>());
    bytes(result.data(), result.size() * sizeof(T));
    return result;
  }
  std::string text();
  Picture picture();

 private:
  oracle::OraclePicture exact_picture();

  int fd_;
  int timeout_s_;
};

}  // namespace gouraud::conformance
