/* Gouraud's own functions: linked, or found by OSMesaGetProcAddress.
 *
 * Methods: where the field knows several ways to do a step of the pipeline, a program may choose among them, to see and
 * to measure what they do. The initial ones conform to the specification; others need not.
 */
#ifndef GOURAUD_H
#define GOURAUD_H

#include <GL/gl.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How the current context draws from now on: "step=name,step=name", such as "coverage=scanline,colors=affine". Steps that
 * are not named have their default; NULL and "" are the defaults of all. What was drawn before is finished first, with the
 * methods that it was drawn with. The environment variable GOURAUD_METHODS says what contexts begin with.
 * GL_FALSE, and nothing is changed: no context is current; GL_INVALID_VALUE, a step or a name is not known (GOURAUD_TRACE=
 * errors prints what it may be); GL_INVALID_OPERATION between glBegin and glEnd. */
GLAPI GLboolean GLAPIENTRY gouraudMethods(const char *methods);

/* The steps that do not have their default, in the form that gouraudMethods takes; "" if all have, or without a current
 * context. Good until this thread's next call of the function. */
GLAPI const char *GLAPIENTRY gouraudMethodsInUse(void);

/* What there is to choose from, a line each: step, name, what it does, source, with tabs between them. The first line
 * of a step is its default. */
GLAPI const char *GLAPIENTRY gouraudMethodTable(void);

#ifdef __cplusplus
}
#endif

#endif
