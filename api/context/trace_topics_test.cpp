#include "api/context/trace_topics.h"

#include <gtest/gtest.h>

namespace gouraud::api {
namespace {

TEST(TraceTopics, AreNamedBetweenCommas) {
  std::string problem;
  EXPECT_EQ(parse_trace_topics("", problem), TraceTopics{});
  EXPECT_EQ(parse_trace_topics("calls,plan", problem), (TraceTopics{.calls = true, .plans = true}));
  EXPECT_EQ(parse_trace_topics("errors,vertex:12", problem), (TraceTopics{.errors = true, .vertex = 12}));
  EXPECT_EQ(parse_trace_topics("pixel:3,40,calls", problem), (TraceTopics{.calls = true, .pixel_x = 3, .pixel_y = 40}));
  EXPECT_EQ(problem, "");
}

TEST(TraceTopics, ThatAreNotKnownAreToldAndLeftOut) {
  for (const char* text : {"call", "vertex", "vertex:", "vertex:-1", "vertex:1x", "pixel:3", "pixel:3,", "pixel:,3", "pixel:a,b"}) {
    std::string problem;
    EXPECT_EQ(parse_trace_topics(text, problem), TraceTopics{}) << text;
    EXPECT_NE(problem, "") << text;
  }
}

}  // namespace
}  // namespace gouraud::api
