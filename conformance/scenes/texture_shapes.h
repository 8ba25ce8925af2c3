// Shared parts of the scenes of texturing: textures, and quads with coordinates.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {

/// Random bytes, the same for the same seed.
std::vector<std::uint8_t> noise(int count, std::uint32_t seed);
/// Bytes that change slowly from texel to texel, of `channels` channels, row by row.
std::vector<std::uint8_t> smooth_texels(int width, int height, int channels, std::uint32_t seed);

/// A level of the 2D texture in use, of noise or smooth.
void noise_image(const GlTable& gl, GLenum target, GLint level, GLint internal_format, int width, int height, GLenum format, std::uint32_t seed);

/// Levels 0 to the last, each of one colour; black last.
void colored_levels(const GlTable& gl, GLenum target, int size);

void filters(const GlTable& gl, GLenum target, GLint minify, GLint magnify);
void wraps(const GlTable& gl, GLenum target, GLint mode);
void environment_mode(const GlTable& gl, GLint mode);

/// A rectangle in window coordinates (pixel_space) with coordinates from (s0, t0) to (s1, t1).
void textured_rectangle(const GlTable& gl, float left, float bottom, float right, float top, float s0, float t0, float s1, float t1);

/// A square floor that recedes, `repeats` textures across.
void textured_floor(const GlTable& gl, float repeats);

}  // namespace gouraud::conformance
