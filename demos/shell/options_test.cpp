#include "demos/shell/options.h"

#include <gtest/gtest.h>

namespace shell {
namespace {

constexpr Demo demo{.name = "demo", .width_px = 300, .height_px = 200};

std::string error_of(const std::vector<std::string>& arguments) {
  std::string error;
  EXPECT_FALSE(parse_options(arguments, demo, error).has_value());
  return error;
}

Options options_of(const std::vector<std::string>& arguments) {
  std::string error;
  const auto options = parse_options(arguments, demo, error);
  EXPECT_TRUE(options.has_value()) << error;
  return options.value_or(Options{});
}

TEST(DemoOptions, NoArgumentsAskForAWindowOfTheDemosOwnSize) {
  const Options options = options_of({});
  EXPECT_FALSE(options.headless);
  EXPECT_EQ(options.width_px, 300);
  EXPECT_EQ(options.height_px, 200);
  EXPECT_EQ(options.out, "demo.png");
}

TEST(DemoOptions, FramesOrOutputAskForNoWindow) {
  EXPECT_TRUE(options_of({"--frames", "7"}).headless);
  EXPECT_EQ(options_of({"--frames", "7"}).frames, 7);
  EXPECT_TRUE(options_of({"--out", "a.png"}).headless);
  EXPECT_FALSE(options_of({"--size", "64x48", "--time", "1.5", "--keys", "left,z"}).headless);
}

TEST(DemoOptions, ValuesArriveAsGiven) {
  const Options options = options_of({"--size", "64x48", "--time", "1.5", "--keys", "left,space,Z", "--click", "12,0"});
  EXPECT_EQ(options.width_px, 64);
  EXPECT_EQ(options.height_px, 48);
  EXPECT_EQ(options.time_s, 1.5);
  EXPECT_EQ(options.keys, (std::vector<int>{key_left, ' ', 'Z'}));
  EXPECT_EQ(options.click, (Click{12, 0}));
}

TEST(DemoOptions, BadArgumentsAreNamed) {
  EXPECT_EQ(error_of({"--fast"}), "unknown argument '--fast' (--help lists the known ones)");
  EXPECT_EQ(error_of({"--frames"}), "--frames needs a number, 1 to 1000000");
  for (const char* size : {"", "64", "x", "64x", "0x48", "64x-48", "64x48x2", "64x48 ", "99999x1", "4e3x4"}) {
    EXPECT_EQ(error_of({"--size", size}), "--size needs WIDTHxHEIGHT, each 1 to 16384") << size;
  }
  for (const char* click : {"", "5", "5x5", "-1,5", "5,", "5,16384"}) error_of({"--click", click});
  for (const char* frames : {"0", "-1", "ten", "1.5", "1000001"}) error_of({"--frames", frames});
  for (const char* time : {"-1", "nan", "inf", "1s", ""}) error_of({"--time", time});
  for (const char* keys : {"", "Left", "left,,right", "left;right"}) error_of({"--keys", keys});
  for (const char* out : {"", "%s.png", "a%d%d.png", "100%.png", "%12d.png"}) error_of({"--out", out});
}

TEST(DemoOptions, ANumberInTheFileNameStandsForTheFrame) {
  EXPECT_FALSE(is_numbered("a.png"));
  EXPECT_TRUE(is_numbered("a%d.png"));
  EXPECT_EQ(frame_file("a.png", 12), "a.png");
  EXPECT_EQ(frame_file("a%d.png", 12), "a12.png");
  EXPECT_EQ(frame_file("a%04d.png", 12), "a0012.png");
  EXPECT_EQ(frame_file("a%4d.png", 12), "a  12.png");
  EXPECT_EQ(frame_file("a%02d.png", 1234), "a1234.png");
}

}  // namespace
}  // namespace shell
