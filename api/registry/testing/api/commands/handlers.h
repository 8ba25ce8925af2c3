// Handlers that only write down what reached them.
#pragma once

#include <initializer_list>
#include <new>

#include "api/context/context.h"

namespace gouraud::api {

inline void note(Context& context, const char* name, std::initializer_list<double> arguments) {
  context.called = name;
  context.arguments = arguments;
}

inline void note_values(Context& context, const char* name, GLenum pname, const GLfloat* values, int count) {
  context.called = name;
  context.arguments = {static_cast<double>(pname)};
  context.arguments.insert(context.arguments.end(), values, values + count);
}

inline void Begin(Context& context, GLenum mode) {
  note(context, "Begin", {double(mode)});
}
inline void End(Context& context) {
  note(context, "End", {});
}
inline GLenum GetError(Context& context) {
  return context.error;
}
inline void DepthFunc(Context& context, GLenum func) {
  note(context, "DepthFunc", {double(func)});
}
inline void Clear(Context& context, GLbitfield mask) {
  note(context, "Clear", {double(mask)});
}
inline void LineWidth(Context&, GLfloat) {
  throw std::bad_alloc();
}
inline void ActiveTexture(Context& context, GLenum unit) {
  note(context, "ActiveTexture", {double(unit)});
}
inline void NewList(Context& context, GLuint, GLenum) {
  context.open_list = true;
}
inline void EndList(Context& context) {
  context.open_list = false;
}

inline void Vertex4f(Context& context, GLfloat x, GLfloat y, GLfloat z, GLfloat w) {
  note(context, "Vertex4f", {x, y, z, w});
}
inline void TexCoord4f(Context& context, GLfloat s, GLfloat t, GLfloat r, GLfloat q) {
  note(context, "TexCoord4f", {s, t, r, q});
}
inline void MultiTexCoord4f(Context& context, GLenum target, GLfloat s, GLfloat t, GLfloat r, GLfloat q) {
  note(context, "MultiTexCoord4f", {double(target), s, t, r, q});
}
inline void Normal3f(Context& context, GLfloat x, GLfloat y, GLfloat z) {
  note(context, "Normal3f", {x, y, z});
}
inline void FogCoordf(Context& context, GLfloat coord) {
  note(context, "FogCoordf", {coord});
}
inline void Color4f(Context& context, GLfloat r, GLfloat g, GLfloat b, GLfloat a) {
  note(context, "Color4f", {r, g, b, a});
}
inline void SecondaryColor3f(Context& context, GLfloat r, GLfloat g, GLfloat b) {
  note(context, "SecondaryColor3f", {r, g, b});
}
inline void Indexf(Context& context, GLfloat c) {
  note(context, "Indexf", {c});
}
inline void EdgeFlag(Context& context, GLboolean flag) {
  note(context, "EdgeFlag", {double(flag)});
}
inline void Rectf(Context& context, GLfloat x1, GLfloat y1, GLfloat x2, GLfloat y2) {
  note(context, "Rectf", {x1, y1, x2, y2});
}
inline void RasterPos4f(Context& context, GLfloat x, GLfloat y, GLfloat z, GLfloat w) {
  note(context, "RasterPos4f", {x, y, z, w});
}
inline void WindowPos3f(Context& context, GLfloat x, GLfloat y, GLfloat z) {
  note(context, "WindowPos3f", {x, y, z});
}
inline void EvalCoord1f(Context& context, GLfloat u) {
  note(context, "EvalCoord1f", {u});
}
inline void EvalCoord2f(Context& context, GLfloat u, GLfloat v) {
  note(context, "EvalCoord2f", {u, v});
}
inline void EvalPoint1(Context& context, GLint i) {
  note(context, "EvalPoint1", {double(i)});
}
inline void EvalPoint2(Context& context, GLint i, GLint j) {
  note(context, "EvalPoint2", {double(i), double(j)});
}

inline void Lightfv(Context& context, GLenum, GLenum pname, const GLfloat* params) {
  note_values(context, "Lightfv", pname, params, 4);
}
inline void LightModelfv(Context& context, GLenum pname, const GLfloat* params) {
  note_values(context, "LightModelfv", pname, params, 4);
}
inline void Materialfv(Context& context, GLenum, GLenum pname, const GLfloat* params) {
  note_values(context, "Materialfv", pname, params, 4);
}
inline void Fogfv(Context& context, GLenum pname, const GLfloat* params) {
  note_values(context, "Fogfv", pname, params, 4);
}
inline void PointParameterfv(Context& context, GLenum pname, const GLfloat* params) {
  note_values(context, "PointParameterfv", pname, params, 4);
}
inline void TexEnvfv(Context& context, GLenum, GLenum pname, const GLfloat* params) {
  note_values(context, "TexEnvfv", pname, params, 4);
}
inline void TexGenfv(Context& context, GLenum, GLenum pname, const GLfloat* params) {
  note_values(context, "TexGenfv", pname, params, 4);
}
inline void TexParameterfv(Context& context, GLenum, GLenum pname, const GLfloat* params) {
  note_values(context, "TexParameterfv", pname, params, 4);
}

inline void LoadMatrixf(Context& context, const GLfloat* m) {
  note_values(context, "LoadMatrixf", 0, m, 16);
}
inline void MultMatrixf(Context& context, const GLfloat* m) {
  note_values(context, "MultMatrixf", 0, m, 16);
}
inline void Rotatef(Context& context, GLfloat angle, GLfloat x, GLfloat y, GLfloat z) {
  note(context, "Rotatef", {angle, x, y, z});
}
inline void Scalef(Context& context, GLfloat x, GLfloat y, GLfloat z) {
  note(context, "Scalef", {x, y, z});
}
inline void Translatef(Context& context, GLfloat x, GLfloat y, GLfloat z) {
  note(context, "Translatef", {x, y, z});
}
inline void MapGrid1f(Context& context, GLint un, GLfloat u1, GLfloat u2) {
  note(context, "MapGrid1f", {double(un), u1, u2});
}
inline void MapGrid2f(Context& context, GLint un, GLfloat u1, GLfloat u2, GLint vn, GLfloat v1, GLfloat v2) {
  note(context, "MapGrid2f", {double(un), u1, u2, double(vn), v1, v2});
}
inline void PixelStorei(Context& context, GLenum pname, GLint param) {
  note(context, "PixelStorei", {double(pname), double(param)});
}
inline void PixelTransferf(Context& context, GLenum pname, GLfloat param) {
  note(context, "PixelTransferf", {double(pname), param});
}

}  // namespace gouraud::api
