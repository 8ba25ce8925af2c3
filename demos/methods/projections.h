// A lesson on projection: one scene through four of them, by GL's matrices and by another school's.
#pragma once

// Of the projection with this number, counted round.
const char* projection_name(int projection);
inline constexpr int projection_count = 4;

// Sets viewport and projection for a picture of this size, and leaves the modelview matrix ready for look_at: the
// identity, or what turns GL's eye space round. Near and far are 0.3 and 60; at `distance` all projections show the same.
void set_projection(int projection, int width_px, int height_px, double distance);
