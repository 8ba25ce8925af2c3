#include "conformance/oracle/blits.h"

#include <gtest/gtest.h>

#include "conformance/oracle/fragments.h"

namespace gouraud::oracle {
namespace {

void set(OraclePicture& picture, int x, int y, int red, int depth = 0) {
  OraclePixel& pixel = picture.pixels[picture.index(x, y)];
  pixel.color[0] = red / 255.0;
  pixel.color_unorm8[0] = static_cast<std::uint8_t>(red);
  pixel.color_lowest[0] = pixel.color_highest[0] = static_cast<float>(pixel.color[0]);
  pixel.depth_units = depth;
  pixel.depth_stored = pixel.depth_lowest = pixel.depth_highest = static_cast<std::uint32_t>(depth);
  pixel.stencil = static_cast<std::uint8_t>(depth);
}

/// Four pixels a row, one row: 0, 40, 80, 120, and depths 0 to 3.
OraclePicture row_of_four() {
  OraclePicture picture = make_picture(4, 1, 24);
  for (int x = 0; x < 4; ++x) set(picture, x, 0, 40 * x, x);
  return picture;
}

double red(const OraclePicture& picture, int x) { return 255 * picture.pixels[picture.index(x, 0)].color[0]; }

pipeline::Blit blit_of(int source0, int source1, int destination0, int destination1, int width) {
  pipeline::Blit blit{{source0, 0, source1, 1}, {destination0, 0, destination1, 1}};
  blit.scissor = {0, 0, width, 1};
  blit.color = true;
  return blit;
}

OraclePicture blitted(const Samples& source, const pipeline::Blit& blit, int width) {
  Samples destination{make_picture(width, 1, 24)};
  blit_samples(source, destination, blit, 0xF);
  return destination[0];
}

TEST(Blits, KeepMirrorAndCut) {
  const OraclePicture same = blitted({row_of_four()}, blit_of(0, 4, 1, 5, 6), 6);
  const OraclePicture mirrored = blitted({row_of_four()}, blit_of(4, 0, 1, 5, 6), 6);
  for (int x = 0; x < 4; ++x) {
    EXPECT_EQ(red(same, x + 1), 40 * x);
    EXPECT_EQ(red(mirrored, x + 1), 120 - 40 * x);
  }
  EXPECT_EQ(same.flags[0], 0);
  pipeline::Blit cut = blit_of(0, 4, 1, 5, 6);
  cut.scissor = {3, 0, 4, 1};
  EXPECT_EQ(red(blitted({row_of_four()}, cut, 6), 2), 0);
  EXPECT_EQ(red(blitted({row_of_four()}, cut, 6), 3), 80);
}

TEST(Blits, LeaveAloneWhatLiesBeyondTheSource) {
  const OraclePicture picture = blitted({row_of_four()}, blit_of(2, 6, 0, 4, 4), 4);
  EXPECT_EQ(red(picture, 1), 120);
  EXPECT_EQ(picture.flags[2], 0);
}

TEST(Blits, BetweenTwoPixelsEitherIsTheNearest) {
  const OraclePicture half = blitted({row_of_four()}, blit_of(0, 4, 0, 2, 2), 2);
  EXPECT_EQ(red(half, 0), 40);
  EXPECT_NE(half.flags[0] & pixel_extrapolated, 0);
  EXPECT_EQ(half.pixels[0].color_lowest[0], 0.0f);
  EXPECT_EQ(half.pixels[0].color_highest[0], 40.0f / 255);
}

TEST(Blits, InterpolateBetweenCentresAndNotBeyondTheRectangle) {
  pipeline::Blit blit = blit_of(1, 3, 0, 4, 4);
  blit.linear = true;
  const OraclePicture picture = blitted({row_of_four()}, blit, 4);
  const double expected[] = {40, 50, 70, 80};
  for (int x = 0; x < 4; ++x) EXPECT_NEAR(red(picture, x), expected[x], 1e-9);
}

TEST(Blits, ResolveToTheMeanOfStoredColoursAndTheFirstDepth) {
  Samples samples(4, make_picture(1, 1, 24));
  for (int k = 0; k < 4; ++k) set(samples[static_cast<std::size_t>(k)], 0, 0, k == 3 ? 1 : 0, 10 + k);
  pipeline::Blit blit = blit_of(0, 1, 0, 1, 1);
  blit.depth = blit.stencil = true;
  const OraclePicture picture = blitted(samples, blit, 1);
  EXPECT_DOUBLE_EQ(red(picture, 0), 0.25);
  EXPECT_EQ(picture.pixels[0].depth_stored, 10u);
  EXPECT_EQ(picture.pixels[0].stencil, 10);
  EXPECT_EQ(picture.flags[0] & pixel_extrapolated, 0);
}

TEST(Blits, KnowThatAColourNearTheMiddleIsStoredAsEitherByte) {
  Samples samples(4, make_picture(1, 1, 24));
  OraclePixel& pixel = samples[1].pixels[0];
  pixel.color[0] = 0.5 / 255;
  pixel.color_lowest[0] = pixel.color_highest[0] = static_cast<float>(pixel.color[0]);
  const OraclePicture picture = blitted(samples, blit_of(0, 1, 0, 1, 1), 1);
  EXPECT_EQ(picture.pixels[0].color_lowest[0], 0.0f);
  EXPECT_EQ(picture.pixels[0].color_highest[0], static_cast<float>(0.25 / 255));
}

TEST(Blits, GiveEverySampleItsOwnOrAllTheSame) {
  Samples samples(4, make_picture(1, 1, 24)), destination = samples, single(1, make_picture(1, 1, 24));
  for (int k = 0; k < 4; ++k) set(samples[static_cast<std::size_t>(k)], 0, 0, 10 * k);
  blit_samples(samples, destination, blit_of(0, 1, 0, 1, 1), 0xF);
  EXPECT_EQ(red(destination[3], 0), 30);
  set(single[0], 0, 0, 7);
  blit_samples(single, destination, blit_of(0, 1, 0, 1, 1), 0xF);
  for (const OraclePicture& picture : destination) EXPECT_EQ(red(picture, 0), 7);
}

TEST(Blits, WriteTheChannelsThatTheDestinationHas) {
  Samples destination(1, make_picture(4, 1, 24));
  blit_samples({row_of_four()}, destination, blit_of(0, 4, 0, 4, 4), 0xE);
  EXPECT_EQ(red(destination[0], 3), 0);
}

}  // namespace
}  // namespace gouraud::oracle
