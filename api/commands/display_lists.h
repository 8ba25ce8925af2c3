// Display lists [GL1.5 §5.4]. What a list holds is recorded by append_record (display_list_recording.cpp).
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// Opens a list. GL_INVALID_VALUE for name 0, GL_INVALID_ENUM for an unknown mode, GL_INVALID_OPERATION if one is open.
void NewList(Context& context, GLuint list, GLenum mode);
/// Gives the open list its name. GL_INVALID_OPERATION if none is open; GL_OUT_OF_MEMORY if it could not be stored: then
/// the name keeps what it had.
void EndList(Context& context);

/// Executes a list. GL_INVALID_VALUE for name 0; nothing happens for a name that is no list, nor beyond
/// max_list_nesting lists that call one another.
void CallList(Context& context, GLuint list);
/// GL_INVALID_ENUM for an unknown type, GL_INVALID_VALUE if n < 0. `lists` holds n offsets of `type`.
void CallLists(Context& context, GLsizei n, GLenum type, const void* lists);
void ListBase(Context& context, GLuint base);

/// The first of `range` new names with empty lists, or 0. GL_INVALID_VALUE if range < 0.
GLuint GenLists(Context& context, GLsizei range);
/// GL_INVALID_VALUE if range < 0.
void DeleteLists(Context& context, GLuint list, GLsizei range);
GLboolean IsList(Context& context, GLuint list);

/// The bytes of one of CallLists' offsets; 0 for an unknown type.
std::size_t list_offset_bytes(GLenum type);

}  // namespace gouraud::api
