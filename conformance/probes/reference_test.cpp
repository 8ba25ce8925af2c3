// The measures of the chart: what they say of pictures whose error is known.
#include "conformance/probes/reference.h"

#include <cmath>

#include <gtest/gtest.h>

namespace gouraud::probes {
namespace {

constexpr int size = 16;

/// A square of colour 100/255 over the lower left quarter of a black target.
Drawing quarter(const GlTable& gl, double knob) {
  project_pixels(gl, size, size);
  return {[knob](const GlTable& table) {
    table.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    table.Color3f(100 / 255.0f, 100 / 255.0f, 100 / 255.0f);
    const auto side = static_cast<float>(8 + knob);
    conformance::draw_rectangle(table, 0, 0, side, side, 0);
  }};
}
const Probe quarter_probe{"quarter", "", size, size, quarter};

/// The picture that is exactly right.
conformance::Picture right_picture(const Reference& reference) {
  conformance::Picture picture;
  picture.width_px = picture.height_px = size;
  picture.depth_bits = 24;
  for (const oracle::OraclePixel& pixel : reference.exact->pixels) {
    picture.rgba.insert(picture.rgba.end(), pixel.color_unorm8.begin(), pixel.color_unorm8.end());
    picture.depth.push_back(pixel.depth_stored);
  }
  for (const int fragments : reference.exact->fragments_written) picture.covered.push_back(fragments > 0 ? 1 : 0);
  return picture;
}

TEST(ChartReference, APictureThatIsRightHasNoError) {
  const Reference reference = exact_reference(quarter_probe, 0);
  const PictureError error = measure(right_picture(reference), reference);
  EXPECT_EQ(error.coverage_percent, 0);
  EXPECT_EQ(error.color_beyond_rounding, 0);
  EXPECT_EQ(error.depth_beyond_rounding, 0);
  EXPECT_NEAR(error.dssim, 0, 1e-9);
}

TEST(ChartReference, WrongPixelsAreCountedInCoverageAndColour) {
  const Reference reference = exact_reference(quarter_probe, 0);
  conformance::Picture picture = right_picture(reference);
  ASSERT_EQ(picture.covered[0], 1);
  picture.covered[0] = 0;
  picture.rgba[0] = picture.rgba[1] = picture.rgba[2] = 0;
  const PictureError error = measure(picture, reference);
  EXPECT_NEAR(error.coverage_percent, 100.0 / 64, 1e-9);
  EXPECT_NEAR(error.color_max, 100, 1e-3);
  EXPECT_NEAR(error.color_beyond_rounding, 99.5 / 64, 1e-3);
  EXPECT_GT(error.dssim, 1e-3);
}

TEST(ChartReference, AreaCoverageIsTheShareOfThePixelBox) {
  // The square ends half way through pixel 8.
  const Reference reference = area_reference(quarter_probe, 0.5, 8);
  const auto red = [&](int x, int y) { return 255 * reference.color[static_cast<std::size_t>(4 * (y * size + x))]; };
  EXPECT_NEAR(red(7, 7), 100, 1e-3);
  EXPECT_NEAR(red(8, 3), 50, 1e-3);
  EXPECT_NEAR(red(8, 8), 25, 1e-3);
  EXPECT_NEAR(red(9, 3), 0, 1e-3);
}

TEST(ChartReference, StructuralSimilarityIsOneOfEqualPicturesAndLessOfOthers) {
  std::vector<double> stripes, grey(size * size, 100), inverse;
  for (int i = 0; i < size * size; ++i) stripes.push_back(i % 2 == 0 ? 200 : 0);
  for (const double value : stripes) inverse.push_back(200 - value);
  EXPECT_NEAR(structural_similarity(stripes, stripes, size, size), 1, 1e-12);
  EXPECT_LT(structural_similarity(stripes, grey, size, size), 0.1);
  EXPECT_LT(structural_similarity(stripes, inverse, size, size), -0.9);  // the structure is there, turned over
}

}  // namespace
}  // namespace gouraud::probes
