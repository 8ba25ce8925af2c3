#include "conformance/probes/plot.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "conformance/harness/drivers.h"

namespace gouraud::probes {
namespace {

TEST(Plot, GnuplotWritesAnSvgWithTitleAndLabels) {
  const conformance::TemporaryFolder folder;
  const std::string path = folder.path() + "/plot.svg";
  write_plot(path, {"a title", "x", "y", true, true, 1e-5,
                   {{"points", PlotSeries::Style::labelled_points, {{1, 0}, {10, 2}}, {"here", "\"there\""}}}});
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_NE(text.str().find("a title"), std::string::npos);
  EXPECT_NE(text.str().find("here"), std::string::npos);
  EXPECT_NE(text.str().find("</svg>"), std::string::npos);
}

TEST(Plot, APathOfAPngGetsOne) {
  const conformance::TemporaryFolder folder;
  const std::string path = folder.path() + "/plot.png";
  write_plot(path, {"a title", "x", "y", true, true, 1e-5, {{"line", PlotSeries::Style::lines, {{1, 1}, {10, 2}}}}});
  std::ifstream file(path, std::ios::binary);
  std::string begin(4, '\0');
  file.read(begin.data(), 4);
  EXPECT_EQ(begin, "\x89PNG");
}

TEST(Plot, NothingToPlotIsAnError) { EXPECT_THROW(write_plot("/tmp/nothing.svg", {}), std::runtime_error); }

}  // namespace
}  // namespace gouraud::probes
