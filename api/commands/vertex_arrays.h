// Where vertex arrays lie and which are enabled [GL1.5 §2.8, §2.9.1]. Drawing from them: draw_arrays.h.
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// All pointers: GL_INVALID_VALUE for a size that Table 2.4 does not list and for a negative stride, GL_INVALID_ENUM
/// for a type that it does not list. Each remembers the buffer bound to ARRAY_BUFFER, and the count, which only
/// EXT_vertex_array's commands give (counted_arrays.h).
void VertexPointer(Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer, GLsizei count = 0);
void NormalPointer(Context& context, GLenum type, GLsizei stride, const void* pointer, GLsizei count = 0);
void ColorPointer(Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer, GLsizei count = 0);
void SecondaryColorPointer(Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer);
void IndexPointer(Context& context, GLenum type, GLsizei stride, const void* pointer, GLsizei count = 0);
void FogCoordPointer(Context& context, GLenum type, GLsizei stride, const void* pointer);
/// Of the unit chosen by ClientActiveTexture.
void TexCoordPointer(Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer, GLsizei count = 0);
void EdgeFlagPointer(Context& context, GLsizei stride, const void* pointer, GLsizei count = 0);
/// GL_INVALID_ENUM for a format that Table 2.5 does not list, GL_INVALID_VALUE for a negative stride.
void InterleavedArrays(Context& context, GLenum format, GLsizei stride, const void* pointer);

/// GL_INVALID_ENUM for what is no array.
void EnableClientState(Context& context, GLenum array);
void DisableClientState(Context& context, GLenum array);
/// GL_INVALID_ENUM unless `texture` is GL_TEXTUREi of a unit.
void ClientActiveTexture(Context& context, GLenum texture);

/// GL_INVALID_ENUM for what is no pointer [GL1.5 §6.1.11].
void GetPointerv(Context& context, GLenum pname, void** params);

/// EXT_compiled_vertex_array: promises that the elements stay as they are. choice: kept, without effect.
/// GL_INVALID_OPERATION if locked already; GL_INVALID_VALUE if first < 0 or count <= 0.
void LockArraysEXT(Context& context, GLint first, GLsizei count);
/// GL_INVALID_OPERATION if not locked.
void UnlockArraysEXT(Context& context);

/// The array that `array` (GL_VERTEX_ARRAY, ...) enables, or null.
VertexArray* find_array(VertexArrayGroup& group, GLenum array);

}  // namespace gouraud::api
