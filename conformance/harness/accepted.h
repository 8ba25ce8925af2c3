// The exceptions of conformance/accepted: one file a scene, NAME.md.
//
//   color_max_llvmpipe <= 3
//   depth_max_oracle <= 1.5
//
//   Why ours is the more exact one, or what freedom the specification leaves [GL1.5 §3.4.1].
//
// First the numbers, one a line: a measure (judge.cpp lists them) and the largest value it may have. Then the reason,
// which cites a section. Nothing else loosens a bound.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace gouraud::conformance {

struct AcceptedExceptions {
  std::map<std::string, double, std::less<>> bounds;  ///< by measure
  std::string reason;
};

/// Reads one file's text; throws std::runtime_error that says what is wrong with it.
AcceptedExceptions parse_accepted(std::string_view text);

/// All *.md of a folder but README.md, by scene name; throws std::runtime_error with the file's name.
std::map<std::string, AcceptedExceptions, std::less<>> read_accepted(const std::string& folder);

}  // namespace gouraud::conformance
