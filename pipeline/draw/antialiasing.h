// Antialiasing by samples: the methods "antialiasing=multisample4", "supersample2" to "supersample32".
//
// The renderer draws into a hidden target that has many samples a pixel, each a picture of its own that is moved by the sample's place,
// and brings their mean into the program's target when that is to be complete. As many samples, as many times the work and the
// memory: what an area is covered by is known to 1 in n x n. The four samples of multisample4 lie in a row and a column each, so that
// nearly upright and nearly level edges have four steps where the 2 x 2 grid has two; every sample is shaded, and so it is in truth
// supersampling with a better pattern. (Multisampling proper shades once a pixel.)
// Sources: F. Crow, "The aliasing problem in computer-generated shaded images", 1977; K. Akeley, "RealityEngine graphics", 1993.
#pragma once

#include <array>
#include <cstddef>

#include "pipeline/draw/methods.h"
#include "pipeline/framebuffer/framebuffer.h"

namespace gouraud::pipeline {

/// How many samples the method has for each pixel: 1 if it is not one of these.
int samples_of(AntialiasingMethod method);
/// Where one of them lies, in pixels from the pixel's lower left corner. Those of targets with four samples [GL1.5 §3.2.1]
/// lie as multisample4's.
std::array<float, 2> sample_position(AntialiasingMethod method, std::size_t sample);

/// A target of the same size and formats with that many samples a pixel, and no accumulation buffer; throws std::bad_alloc.
Framebuffer make_sampled(const Framebuffer& like, int samples);
/// Every sample becomes what its pixel is.
void load_samples(const Framebuffer& from, const Framebuffer& sampled);
/// Every pixel gets the mean colour of its samples, and depth and stencil of one of those near its middle.
void resolve_samples(const Framebuffer& sampled, const Framebuffer& to);

}  // namespace gouraud::pipeline
