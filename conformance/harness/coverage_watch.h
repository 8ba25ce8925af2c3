// Finds the pixels that a scene draws, by looking at the buffers around every glClear.
//
// A pixel is covered if, since its colour was last cleared, it held a colour or depth that no clear left there. A fragment may have the clear
// colour, so the scene is drawn on two backgrounds: once as it is, and once on other clear colours (this watch); a
// fragment cannot have both colours. What changes neither colour nor depth on either background is not drawn.
#pragma once

#include <cstdint>
#include <vector>

#include "conformance/harness/offscreen.h"
#include "conformance/harness/picture.h"

namespace gouraud::conformance {

class CoverageWatch {
 public:
  explicit CoverageWatch(OffscreenContext& context);
  ~CoverageWatch();
  CoverageWatch(const CoverageWatch&) = delete;
  CoverageWatch& operator=(const CoverageWatch&) = delete;

  /// The context's table, in which glClear clears to another colour than asked. One watch at a time in a process.
  const GlTable& gl() const { return gl_; }

  /// After the scene has drawn through gl(): the pixels covered here or in `plain`, the same scene drawn as it is.
  std::vector<std::uint8_t> covered(const Picture& plain);

 private:
  static void APIENTRY watched_clear(GLbitfield mask);
  void clear(GLbitfield mask);
  void mark(const Picture& now, const Picture& background);

  OffscreenContext& context_;
  GlTable gl_;
  Picture background_;        ///< what the last clear left
  Picture plain_background_;  ///< what it would have left with the scene's own clear colour
  std::vector<std::uint8_t> covered_;
};

}  // namespace gouraud::conformance
