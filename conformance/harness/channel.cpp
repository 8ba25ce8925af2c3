#include "conformance/harness/channel.h"

#include <cerrno>
#include <cstddef>

#include <poll.h>
#include <unistd.h>

namespace gouraud::conformance {

void Writer::bytes(const void* data, std::size_t size) {
  const auto* next = static_cast<const std::byte*>(data);
  while (size > 0) {
    const ssize_t written = ::write(fd_, next, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) throw ChannelClosed("nobody reads");
    next += written;
    size -= static_cast<std::size_t>(written);
  }
}

void Writer::text(std::string_view text) {
  value(static_cast<std::uint64_t>(text.size()));
  bytes(text.data(), text.size());
}

void Writer::picture(const Picture& picture) {
  value(picture.width_px);
  value(picture.height_px);
  value(picture.depth_bits);
  array(picture.rgba);
  array(picture.depth);
  array(picture.covered);
  array(picture.gl_errors);
  value(picture.read_differences);
  value(picture.exact.has_value());
  if (picture.exact) exact_picture(*picture.exact);
}

void Writer::exact_picture(const oracle::OraclePicture& exact) {
  value(exact.width_px);
  value(exact.height_px);
  value(exact.depth_bits);
  array(exact.pixels);
  array(exact.flags);
  array(exact.fragments_written);
  value(exact.knife_edge_vertices);
  value(static_cast<std::uint64_t>(exact.alternatives.size()));
  for (const auto& [index, outcomes] : exact.alternatives) {
    value(static_cast<std::uint64_t>(index));
    array(outcomes);
  }
}

void Reader::bytes(void* data, std::size_t size) {
  auto* next = static_cast<std::byte*>(data);
  while (size > 0) {
    pollfd waiting{fd_, POLLIN, 0};
    const int ready = ::poll(&waiting, 1, timeout_s_ * 1000);
    if (ready < 0 && errno == EINTR) continue;
    if (ready == 0) throw ChannelTimeout("no answer in " + std::to_string(timeout_s_) + " s");
    const ssize_t received = ::read(fd_, next, size);
    if (received < 0 && errno == EINTR) continue;
    if (received <= 0) throw ChannelClosed("the other side ended");
    next += received;
    size -= static_cast<std::size_t>(received);
  }
}

std::string Reader::text() {
  std::string result(value<std::uint64_t>(), '\0');
  bytes(result.data(), result.size());
  return result;
}

Picture Reader::picture() {
  Picture picture;
  picture.width_px = value<int>();
  picture.height_px = value<int>();
  picture.depth_bits = value<int>();
  picture.rgba = array<std::uint8_t>();
  picture.depth = array<std::uint32_t>();
  picture.covered = array<std::uint8_t>();
  picture.gl_errors = array<std::uint32_t>();
  picture.read_differences = value<std::uint64_t>();
  if (value<bool>()) picture.exact = exact_picture();
  return picture;
}

oracle::OraclePicture Reader::exact_picture() {
  oracle::OraclePicture exact;
  exact.width_px = value<int>();
  exact.height_px = value<int>();
  exact.depth_bits = value<int>();
  exact.pixels = array<oracle::OraclePixel>();
  exact.flags = array<std::uint8_t>();
  exact.fragments_written = array<std::int32_t>();
  exact.knife_edge_vertices = value<std::int64_t>();
  for (auto left = value<std::uint64_t>(); left > 0; --left) {
    const auto index = value<std::uint64_t>();
    exact.alternatives[index] = array<oracle::OraclePixel>();
  }
  return exact;
}

}  // namespace gouraud::conformance
