/* Off-screen rendering into the program's own memory: the OSMesa interface, as Gouraud implements it.
 *
 * A context renders into a picture of its own and copies it to the buffer given to OSMesaMakeCurrent at glFlush, at
 * glFinish and when it ceases to be current, if anything was drawn since the last copy. Rows run from bottom to top
 * (see OSMESA_Y_UP). A thread has at most one current context, and a context is used by one thread at a time.
 */
#ifndef OSMESA_H
#define OSMESA_H

#include <GL/gl.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The version of the interface: programs that look for OSMesaCreateContextAttribs want 11.2 or more. */
#define OSMESA_MAJOR_VERSION 11
#define OSMESA_MINOR_VERSION 2
#define OSMESA_PATCH_VERSION 0

/* Formats of the buffer. The order of the names is the order in memory; OSMESA_RGB_565 is a 16-bit word with red on
 * top. With GL_UNSIGNED_SHORT and GL_FLOAT, OSMESA_BGRA and OSMESA_ARGB are stored as R, G, B, A, as Mesa does.
 * A context of format OSMESA_COLOR_INDEX can be created but never made current. */
#define OSMESA_COLOR_INDEX GL_COLOR_INDEX
#define OSMESA_RGBA GL_RGBA
#define OSMESA_BGRA 0x1
#define OSMESA_ARGB 0x2
#define OSMESA_RGB GL_RGB
#define OSMESA_BGR 0x4
#define OSMESA_RGB_565 0x5

/* OSMesaPixelStore and OSMesaGetIntegerv. OSMESA_ROW_LENGTH: pixels from one row to the next, 0 (initially) for the
 * width. OSMESA_Y_UP: zero for rows from top to bottom; initially 1. Both act at the next copy. */
#define OSMESA_ROW_LENGTH 0x10
#define OSMESA_Y_UP 0x11

/* OSMesaGetIntegerv alone. */
#define OSMESA_WIDTH 0x20
#define OSMESA_HEIGHT 0x21
#define OSMESA_FORMAT 0x22
#define OSMESA_TYPE 0x23
#define OSMESA_MAX_WIDTH 0x24
#define OSMESA_MAX_HEIGHT 0x25

/* OSMesaCreateContextAttribs, besides OSMESA_FORMAT. */
#define OSMESA_DEPTH_BITS 0x30
#define OSMESA_STENCIL_BITS 0x31
#define OSMESA_ACCUM_BITS 0x32
#define OSMESA_PROFILE 0x33
#define OSMESA_CORE_PROFILE 0x34
#define OSMESA_COMPAT_PROFILE 0x35
#define OSMESA_CONTEXT_MAJOR_VERSION 0x36
#define OSMESA_CONTEXT_MINOR_VERSION 0x37

typedef struct osmesa_context *OSMesaContext;
typedef void (*OSMESAproc)(void);

/* A context with 24 bits of depth, 8 of stencil and no accumulation buffer. NULL for an unknown format. */
GLAPI OSMesaContext GLAPIENTRY OSMesaCreateContext(GLenum format, OSMesaContext sharelist);

/* As many bits as asked for, or the nearest that there is. NULL for an unknown format, negative bits or no memory. */
GLAPI OSMesaContext GLAPIENTRY OSMesaCreateContextExt(GLenum format, GLint depthBits, GLint stencilBits,
                                                      GLint accumBits, OSMesaContext sharelist);

/* attribList: pairs of attribute and value, ended by 0. What is not listed: OSMESA_RGBA, no depth, stencil or
 * accumulation buffer, OSMESA_COMPAT_PROFILE, version 1.0. NULL for an unknown attribute or value, the core profile, a
 * version above 1.5 or below 1.0. */
GLAPI OSMesaContext GLAPIENTRY OSMesaCreateContextAttribs(const int *attribList, OSMesaContext sharelist);

/* Destroys ctx (NULL: does nothing). If it is current, the thread has no current context afterwards, and nothing is
 * copied. */
GLAPI void GLAPIENTRY OSMesaDestroyContext(OSMesaContext ctx);

/* Makes ctx current in this thread, to be copied to `buffer` of width x height pixels of `type`: GL_UNSIGNED_BYTE,
 * GL_UNSIGNED_SHORT or GL_FLOAT, for OSMESA_RGB_565 GL_UNSIGNED_SHORT_5_6_5. With ctx and buffer NULL: no context.
 * GL_FALSE, and nothing is changed, if one of them is NULL, a side is not in 1..16384, the type does not suit the
 * format, or memory is short. With size and type unchanged the picture is kept; otherwise it begins as zeros. The
 * first call sets the viewport and the scissor box. */
GLAPI GLboolean GLAPIENTRY OSMesaMakeCurrent(OSMesaContext ctx, void *buffer, GLenum type, GLsizei width,
                                             GLsizei height);

/* This thread's current context, or NULL. */
GLAPI OSMesaContext GLAPIENTRY OSMesaGetCurrentContext(void);

/* Sets OSMESA_ROW_LENGTH or OSMESA_Y_UP of the current context. Negative row lengths are ignored. */
GLAPI void GLAPIENTRY OSMesaPixelStore(GLint pname, GLint value);

/* A value of the current context. Without one: 0, but the maxima are always given. An unknown pname: *value is kept. */
GLAPI void GLAPIENTRY OSMesaGetIntegerv(GLint pname, GLint *value);

/* The depth buffer as of the last copy (at the first call: as of now): rows from bottom to top without gaps, 2 or 4
 * bytes a value, in the machine's byte order. 2 bytes: 16 bits of depth. 4 bytes: 24 bits of depth, above them 8 of
 * stencil; or 32 bits of depth, where GL_DEPTH_BITS is 32. The memory is the context's and keeps its place until the
 * picture changes its size. GL_FALSE and zeros without a depth buffer or before the first OSMesaMakeCurrent. */
GLAPI GLboolean GLAPIENTRY OSMesaGetDepthBuffer(OSMesaContext ctx, GLint *width, GLint *height, GLint *bytesPerValue,
                                                void **buffer);

/* The size, the context's format and the buffer last given to OSMesaMakeCurrent. GL_FALSE and zeros if there is none. */
GLAPI GLboolean GLAPIENTRY OSMesaGetColorBuffer(OSMesaContext ctx, GLint *width, GLint *height, GLint *format,
                                                void **buffer);

/* The function of that name, gl or OSMesa; NULL if there is none. */
GLAPI OSMESAproc GLAPIENTRY OSMesaGetProcAddress(const char *funcName);

/* Does nothing: OpenGL 1.5 always clamps fragment colors to [0, 1]. */
GLAPI void GLAPIENTRY OSMesaColorClamp(GLboolean enable);

/* Does nothing: there are no filters. */
GLAPI void GLAPIENTRY OSMesaPostprocess(OSMesaContext osmesa, const char *filter, unsigned enable_value);

#ifdef __cplusplus
}
#endif

#endif
