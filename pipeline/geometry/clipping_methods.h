// Triangles that lie partly outside the clip volume, without clipping or with less of it: the methods
// "clipping=guard_band" and "clipping=none".
#pragma once

#include "pipeline/draw/draw_state.h"
#include "pipeline/geometry/processed_vertices.h"

namespace gouraud::pipeline {

/// A triangle that leaves the window by this much at most needs no clipping: edge functions hold it.
inline constexpr float guard_band_px = 8192.0f;

/// The guard band: a triangle that crosses no plane but those of the window's sides, and stays within the band, goes to
/// the rasterizer as it is, which visits no pixel outside the viewport anyway. What is left to the clipper is what it alone can do:
/// the near and far planes, the user's planes, and what is far larger than the window. As exact as clipping, and more so:
/// no new vertices, no new edges between their rounded positions.
/// Source: hardware since the 1990s, such as the Direct3D 7 caps GuardBandLeft ... GuardBandBottom (Microsoft, 1999).
bool fits_guard_band(const ViewportState& viewport, const ProcessedVertices& vertices, const AssembledTriangle& triangle);

/// No clipping: vertices are divided by w wherever they are. Simple; and what comes out is wrong as soon as one lies beside or behind the
/// eye: its image jumps to the other side of the window, through infinity, and the triangle with it. Coordinates are
/// cut off where the rasterizer would overflow, each by itself, which bends the triangle. What is nearer than the near plane is
/// drawn with the near plane's depth, what is farther than the far plane with the far plane's. False if a position is no number.
bool force_into_window(const ViewportState& viewport, const AssembledTriangle& triangle, ProcessedVertices& vertices);

}  // namespace gouraud::pipeline
