// What legacy programs took from GLU and GLUT: cameras, and solid shapes with normals and texture coordinates. Ordinary
// immediate mode, so that a demo may put them into display lists.
#pragma once

namespace shell {

struct Vec3 {
  float x = 0, y = 0, z = 0;
};

// Multiplies the current matrix by a perspective projection. `field_of_view_deg` is the angle from bottom to top.
void perspective(double field_of_view_deg, double aspect, double near_z, double far_z);

// Multiplies the current matrix by one that takes `eye` to the origin and `target` onto the negative z axis.
void look_at(const Vec3& eye, const Vec3& target, const Vec3& up);

// Sets a viewport of the whole window and a perspective projection, and selects the modelview matrix.
void set_camera(int width_px, int height_px, double field_of_view_deg, double near_z, double far_z);

// Around the origin, its poles on the y axis; s goes round it, t from pole to pole.
void solid_sphere(float radius, int slices, int stacks);

// In the xy plane: a tube of radius `tube_radius` whose centre runs at `ring_radius`; s goes round the ring.
void solid_torus(float tube_radius, float ring_radius, int sides, int rings);

// Around the origin, with the whole texture on each face.
void solid_box(float width, float height, float depth);

// A square in the xz plane that looks up, from -half to half, of cells x cells quads; s and t go from 0 to `repeats`.
void ground(float half, int cells, float repeats);

}  // namespace shell
