// Buffer objects [GL1.5 §2.9, §6.1.13].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// GL_INVALID_VALUE if n < 0.
void GenBuffers(Context& context, GLsizei n, GLuint* buffers);
void DeleteBuffers(Context& context, GLsizei n, const GLuint* buffers);
/// True once the name has been bound.
GLboolean IsBuffer(Context& context, GLuint buffer);

/// This one and all below: GL_INVALID_ENUM unless target is ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER, PIXEL_PACK_BUFFER or
/// PIXEL_UNPACK_BUFFER. Makes the object if
/// there is none of that name.
void BindBuffer(Context& context, GLenum target, GLuint buffer);

/// All below: GL_INVALID_OPERATION if no buffer is bound to target.

/// GL_INVALID_ENUM for an unknown usage, GL_INVALID_VALUE if size < 0, GL_OUT_OF_MEMORY if there is no such room.
/// choice: a new store that is given no data holds zeros; sizes that BUFFER_SIZE could not tell are out of memory.
void BufferData(Context& context, GLenum target, GLsizeiptr size, const void* data, GLenum usage);
/// Both: GL_INVALID_VALUE for a range that is not within the store, GL_INVALID_OPERATION if it is mapped.
void BufferSubData(Context& context, GLenum target, GLintptr offset, GLsizeiptr size, const void* data);
void GetBufferSubData(Context& context, GLenum target, GLintptr offset, GLsizeiptr size, void* data);
/// Null on error: GL_INVALID_ENUM for an unknown access, GL_INVALID_OPERATION if mapped already, GL_OUT_OF_MEMORY if
/// the store is empty.
void* MapBuffer(Context& context, GLenum target, GLenum access);
/// GL_INVALID_OPERATION and false if not mapped.
GLboolean UnmapBuffer(Context& context, GLenum target);
/// Both: GL_INVALID_ENUM for an unknown pname.
void GetBufferParameteriv(Context& context, GLenum target, GLenum pname, GLint* params);
void GetBufferPointerv(Context& context, GLenum target, GLenum pname, void** params);

}  // namespace gouraud::api
