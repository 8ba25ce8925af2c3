#include "api/context/trace_topics.h"

#include <algorithm>
#include <charconv>

namespace gouraud::api {
namespace {

/// The text in front of the next comma, which is taken off.
std::string_view take_word(std::string_view& rest) {
  const std::size_t end = std::min(rest.find(','), rest.size());
  const std::string_view word = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return word;
}

template <class Number>
bool read(std::string_view text, Number& number) {
  Number value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 0) return false;
  number = value;
  return true;
}

}  // namespace

TraceTopics parse_trace_topics(std::string_view rest, std::string& problem) {
  constexpr std::string_view vertex = "vertex:", pixel = "pixel:";
  TraceTopics topics;
  while (!rest.empty()) {
    const std::string_view word = take_word(rest);
    bool known = true;
    if (word == "calls") {
      topics.calls = true;
    } else if (word == "errors") {
      topics.errors = true;
    } else if (word == "plan") {
      topics.plans = true;
    } else if (word.starts_with(vertex)) {
      known = read(word.substr(vertex.size()), topics.vertex);
    } else if (word.starts_with(pixel)) {
      std::int32_t x = 0, y = 0;
      known = read(word.substr(pixel.size()), x) && read(take_word(rest), y);
      if (known) {
        topics.pixel_x = x;
        topics.pixel_y = y;
      }
    } else {
      known = word.empty();
    }
    if (!known) problem = "'" + std::string(word.substr(0, 40)) + "' is not known; it may be calls, errors, plan, vertex:N or pixel:X,Y";
  }
  return topics;
}

}  // namespace gouraud::api
