// Queries of state [GL1.5 §2.5, §6.1.1, §6.1.2, §6.1.11].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

GLenum GetError(Context& context);

/// GL_INVALID_ENUM and null unless VENDOR, RENDERER, VERSION or EXTENSIONS.
const GLubyte* GetString(Context& context, GLenum name);

/// The extension of that number, below NUM_EXTENSIONS: as in GL 3.0, which programs call where they find it. GL_INVALID_ENUM
/// and null unless EXTENSIONS, GL_INVALID_VALUE and null for a number that is too large.
const GLubyte* GetStringi(Context& context, GLenum name, GLuint index);

/// Values of the state table (state_table.h) or of a capability, converted; GL_INVALID_ENUM for what is neither.
void GetBooleanv(Context& context, GLenum pname, GLboolean* data);
void GetIntegerv(Context& context, GLenum pname, GLint* data);
void GetFloatv(Context& context, GLenum pname, GLfloat* data);
void GetDoublev(Context& context, GLenum pname, GLdouble* data);
/// Of a later version: programs that link it would find another library's otherwise. Rounded as GetIntegerv.
void GetInteger64v(Context& context, GLenum pname, GLint64* data);

}  // namespace gouraud::api
