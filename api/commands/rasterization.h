// Points, lines and polygons [GL1.5 §3.3, §3.4, §3.5.1, §3.5.4], the face directions of §2.14.1, and SampleCoverage.
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// Both: GL_INVALID_VALUE unless greater than 0.
void PointSize(Context& context, GLfloat size);
void LineWidth(Context& context, GLfloat width);

/// GL_INVALID_ENUM for an unknown pname; GL_INVALID_VALUE if a size is negative or no number.
void PointParameterfv(Context& context, GLenum pname, const GLfloat* params);

/// `factor` is clamped to [1, 256].
void LineStipple(Context& context, GLint factor, GLushort pattern);

/// The last of both decides [GL1.5 §3.5.5]. `units` counts steps of the depth buffer; `bias` is in window z, as
/// EXT_polygon_offset has it.
/// choice: what one sets, the other reads as 0, since neither can say it (Mesa keeps one number in two units).
void PolygonOffset(Context& context, GLfloat factor, GLfloat units);
void PolygonOffsetEXT(Context& context, GLfloat factor, GLfloat bias);

/// All: GL_INVALID_ENUM for unknown values.
void FrontFace(Context& context, GLenum mode);
void CullFace(Context& context, GLenum mode);
void PolygonMode(Context& context, GLenum face, GLenum mode);

/// `value` is clamped to [0, 1] [GL1.5 §4.1.3].
void SampleCoverage(Context& context, GLfloat value, GLboolean invert);

}  // namespace gouraud::api
