// The pictures of all framebuffers that were drawn into or read, each sample's a picture of its own [GL1.5 §3.2.1].
//
// A framebuffer is known by its planes of colour, depth and stencil. What a plane holds comes from the picture that had
// it last, or, if there is none, from the plane as it is: what an application has put there is given.
#pragma once

#include <list>
#include <vector>

#include "conformance/oracle/oracle.h"

namespace gouraud::oracle {

/// One picture a sample.
using Samples = std::vector<OraclePicture>;

class Targets {
 public:
  /// The pictures of a framebuffer, up to date; valid until the next call. They hold its planes from now on.
  Samples& pictures_of(const pipeline::Framebuffer& framebuffer);

 private:
  struct Target {
    pipeline::Framebuffer framebuffer;  ///< keeps the planes alive: no other can take their addresses
    Samples samples;
  };
  const Target* latest_with(pipeline::TiledBuffer pipeline::Framebuffer::*plane, const pipeline::TiledBuffer& buffer) const;
  Samples made_of_latest(const pipeline::Framebuffer& framebuffer) const;

  std::list<Target> targets_;  ///< the latest first
};

/// Where a multisampled pixel has its samples, in pixels from its lower left corner [GL1.5 §3.2.1].
struct SamplePosition {
  double x = 0.5, y = 0.5;
};
inline constexpr std::array<SamplePosition, 4> sample_places{{{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}}};

}  // namespace gouraud::oracle
