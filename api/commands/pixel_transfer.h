// Pixel transfer and the pixel maps [GL1.5 §3.6.3, §3.6.5].
#pragma once

#include <cstddef>
#include <cstdint>

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// GL_INVALID_ENUM for an unknown parameter. PixelTransferi converts.
void PixelTransferf(Context& context, GLenum pname, GLfloat param);
void PixelTransferi(Context& context, GLenum pname, GLint param);

/// All: GL_INVALID_ENUM for an unknown map, GL_INVALID_VALUE for a size outside 1 .. max_pixel_map_table, and, of a map
/// that an index addresses, one that is no power of two. Of a pixel buffer: see check_unpack.
void PixelMapfv(Context& context, GLenum map, GLsizei mapsize, const GLfloat* values);
void PixelMapuiv(Context& context, GLenum map, GLsizei mapsize, const GLuint* values);
void PixelMapusv(Context& context, GLenum map, GLsizei mapsize, const GLushort* values);

/// All: GL_INVALID_ENUM for an unknown map.
void GetPixelMapfv(Context& context, GLenum map, GLfloat* values);
void GetPixelMapuiv(Context& context, GLenum map, GLuint* values);
void GetPixelMapusv(Context& context, GLenum map, GLushort* values);

/// What pixel transfer does to colours and depths: nothing in most programs.
bool transfers_color(const PixelTransferGroup& transfer);
bool transfers_depth(const PixelTransferGroup& transfer);
bool transfers_stencil(const PixelTransferGroup& transfer);

/// In place: arithmetic on components and the lookup of RGBA.
void transfer_color(const State& state, float* rgba, std::size_t pixels);
/// Shift, offset and the lookup that gives RGBA.
void transfer_index_to_color(const State& state, const std::uint32_t* indices, std::size_t pixels, float* rgba);
void transfer_stencil(const State& state, std::uint32_t* indices, std::size_t pixels);
void transfer_depth(const State& state, double* depths, std::size_t pixels);

}  // namespace gouraud::api
