// The array pointers of EXT_vertex_array: those of [GL1.5 §2.8], told how many elements there are.
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// All: the errors of the pointers without a count, and GL_INVALID_VALUE for a negative count. Indices are not held
/// against it.
void VertexPointerEXT(Context& context, GLint size, GLenum type, GLsizei stride, GLsizei count, const void* pointer);
void NormalPointerEXT(Context& context, GLenum type, GLsizei stride, GLsizei count, const void* pointer);
void ColorPointerEXT(Context& context, GLint size, GLenum type, GLsizei stride, GLsizei count, const void* pointer);
void IndexPointerEXT(Context& context, GLenum type, GLsizei stride, GLsizei count, const void* pointer);
void TexCoordPointerEXT(Context& context, GLint size, GLenum type, GLsizei stride, GLsizei count, const void* pointer);
void EdgeFlagPointerEXT(Context& context, GLsizei stride, GLsizei count, const GLboolean* pointer);

}  // namespace gouraud::api
