// Lights, light model, materials, ColorMaterial and the shade model [GL1.5 §2.14.2, §2.14.3, §2.14.7].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// All: GL_INVALID_ENUM for an unknown light, face, parameter or mode; GL_INVALID_VALUE for a value outside the range
/// of Table 2.10 (NaN is outside every range). Positions and spot directions are transformed by the modelview matrix
/// now.
void Lightfv(Context& context, GLenum light, GLenum pname, const GLfloat* params);
void LightModelfv(Context& context, GLenum pname, const GLfloat* params);
/// Legal between Begin and End. Has no effect on parameters that follow the current colour.
void Materialfv(Context& context, GLenum face, GLenum pname, const GLfloat* params);
void ColorMaterial(Context& context, GLenum face, GLenum mode);
void ShadeModel(Context& context, GLenum mode);

void GetLightfv(Context& context, GLenum light, GLenum pname, GLfloat* params);
void GetLightiv(Context& context, GLenum light, GLenum pname, GLint* params);
void GetMaterialfv(Context& context, GLenum face, GLenum pname, GLfloat* params);
void GetMaterialiv(Context& context, GLenum face, GLenum pname, GLint* params);

/// While COLOR_MATERIAL is enabled: writes the current colour to the parameters that follow it. To be called before
/// they are read, and before what follows changes.
void sync_color_material(State& state);

}  // namespace gouraud::api
