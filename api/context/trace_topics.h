// What GOURAUD_TRACE asks for.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace gouraud::api {

struct TraceTopics {
  bool calls = false, errors = false, plans = false;
  std::int64_t vertex = -1;                     ///< -1: none
  std::int32_t pixel_x = -1, pixel_y = -1;      ///< -1: none
  bool operator==(const TraceTopics&) const = default;
};

/// From "calls,plan,errors,vertex:N,pixel:X,Y". What is not understood is left out; then `problem` says so in one line.
TraceTopics parse_trace_topics(std::string_view text, std::string& problem);

}  // namespace gouraud::api
