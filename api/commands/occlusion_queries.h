// Occlusion queries [GL1.5 §4.1.7, §6.1.12].
//
// choice: a result is available as soon as it is asked for: asking draws what is pending.
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// Bits of a result: more count as the largest number they hold.
inline constexpr int query_counter_bits = 32;

/// GL_INVALID_VALUE for a negative n, GL_INVALID_OPERATION while a query is active.
void GenQueries(Context& context, GLsizei n, GLuint* ids);
void DeleteQueries(Context& context, GLsizei n, const GLuint* ids);
/// True of a name that a query has begun with.
GLboolean IsQuery(Context& context, GLuint id);

/// GL_INVALID_ENUM unless target is SAMPLES_PASSED; GL_INVALID_OPERATION for the name 0, or while a query is active.
void BeginQuery(Context& context, GLenum target, GLuint id);
/// GL_INVALID_OPERATION while no query is active.
void EndQuery(Context& context, GLenum target);

/// CURRENT_QUERY or QUERY_COUNTER_BITS.
void GetQueryiv(Context& context, GLenum target, GLenum pname, GLint* params);
/// QUERY_RESULT or QUERY_RESULT_AVAILABLE; GL_INVALID_OPERATION if id is no query, or the active one. A result too large
/// for the type is the largest number of the type.
void GetQueryObjectiv(Context& context, GLuint id, GLenum pname, GLint* params);
void GetQueryObjectuiv(Context& context, GLuint id, GLenum pname, GLuint* params);

}  // namespace gouraud::api
