// The HTML report: one file with everything in it, pictures included; it opens without a network.
#pragma once

#include <sstream>
#include <string>
#include <string_view>

#include "conformance/harness/judge.h"
#include "conformance/harness/png.h"

namespace gouraud::conformance {

struct SceneResult {
  const Scene* scene = nullptr;
  SceneRenderings renderings;
  Verdict verdict;
  std::string accepted_reason;  ///< empty if nothing is accepted
};

/// One scene's line on the terminal, without a line feed, and the two lines that explain the columns.
std::string summary_line(const SceneResult& result);
std::string summary_header();

class Report {
 public:
  /// `candidate` names whose pictures are judged: ours, or who stands in for it.
  explicit Report(std::string_view candidate) : candidate_(candidate) {}
  /// Takes in all that it will show of the scene; the pictures may go afterwards.
  void add(const SceneResult& result);
  /// Writes folder/report.html, making the folder; throws std::runtime_error.
  void write(const std::string& folder) const;

 private:
  std::string candidate_;
  std::ostringstream overview_, scenes_;
  int passed_ = 0, failed_ = 0;
};

/// Where ours differs from another picture: black where equal; brighter the larger the difference (64 times amplified,
/// so that 1/255 is visible); magenta where only ours is covered, cyan where only the other is.
RgbImage difference_map(const Picture& ours, const Picture& other);

/// Colour error of a picture against the oracle's exact one: black up to 0.5/255, which rounding costs, and mid grey at
/// 1/255; coverage as in difference_map.
RgbImage error_map(const Picture& picture, const Picture& oracle);

}  // namespace gouraud::conformance
