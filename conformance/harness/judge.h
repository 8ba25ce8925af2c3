// The verdict over one scene: every number that was measured, the bound it must keep, and what is accepted beyond.
//
// The bounds are those of ARCHITECTURE §5 and stand in judge.cpp, one row a measure. A number may pass its bound only
// if conformance/accepted lists it for the scene with a reason; then the listed bound holds, and a listing that is not
// needed any more fails the scene as well.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/harness/accepted.h"
#include "conformance/harness/picture.h"
#include "conformance/scenes/scene.h"

namespace gouraud::conformance {

/// What one driver gave for a scene: a picture, or why there is none.
struct Rendering {
  std::optional<Picture> picture;
  std::string failure;
};

/// The picture, null if there is none.
inline const Picture* picture_of(const std::optional<Rendering>& rendering) {
  return rendering && rendering->picture ? &*rendering->picture : nullptr;
}

/// All renderings of a scene; one that was not asked for is absent.
struct SceneRenderings {
  std::optional<Rendering> ours, llvmpipe, softpipe, oracle;
};

struct Measure {
  std::string_view key;   ///< as in conformance/accepted: "color_max_oracle"
  std::string_view says;  ///< what it is, for a reader
  double value = 0.0;
  std::optional<double> bound;     ///< absent: reported, not judged
  std::optional<double> accepted;  ///< a larger bound, listed with its reason
  bool holds() const { return !bound || value <= (accepted ? *accepted : *bound); }
};

struct Verdict {
  std::vector<Measure> measures;
  std::vector<std::string> complaints;  ///< one sentence each; none: the scene passes
  bool passed() const { return complaints.empty(); }
  /// The value of a measure, absent if it was not taken.
  std::optional<double> value(std::string_view key) const;
};

Verdict judge(const Scene& scene, const SceneRenderings& renderings, const AcceptedExceptions* accepted);

/// The keys that conformance/accepted may list.
bool is_measure(std::string_view key);

}  // namespace gouraud::conformance
