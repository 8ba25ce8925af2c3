"""Writes the entry points: checked.h (what a command does), entry_*.cpp (the exported symbols), watched_*.cpp (the
out-of-line way of a call that is traced or compiled into a display list) and the table of names."""

import families
import handlers as handlers_module
import records

NOTE = "// Written by api/registry/generate.py.\n"


def parameter_shapes_h():
    """One switch a parameter family: pname -> ParameterShape."""
    text = [NOTE, "#pragma once\n\n#include <GL/gl.h>\n\n#include \"api/registry/conversions.h\"\n\n"
            "namespace gouraud::api {\n"]
    for family in families.PARAMETER_FAMILIES:
        rows = [(name, "{4, true}") for name in family.colors.split()]
        rows += [(name, f"{{{count}}}") for name, count in family.vectors.items()]
        rows += [(name, "{1}") for name in family.scalars.split()]
        rows += [(name, "{1, false, true}") for name in family.enums.split()]
        text.append(f"\ninline ParameterShape {handlers_module.shape_function(family)}(GLenum pname) {{\n"
                    "  switch (pname) {\n")
        for shape in dict.fromkeys(shape for _, shape in rows):
            text += [f"    case GL_{name}:\n" for name, its_shape in rows if its_shape == shape]
            text.append(f"      return {shape};\n")
        text.append("    default:\n      return {};\n  }\n}\n")
    return "".join(text) + "\n}  // namespace gouraud::api\n"


def checked_h(registry, handlers):
    includes = "".join(f'#include "api/commands/{header}"\n' for header in sorted(set(handlers.values())))
    bodies = "\n".join(_checked(command, handlers) for command in registry.commands.values())
    return f"""{NOTE}\
// Each command as the specification has it: refused between Begin and End where it is not legal [GL1.5 §2.6.3], else
// carried out by its handler.
#pragma once

#include "api/registry/conversions.h"
#include "api/registry/entry.h"
#include "parameter_shapes.h"
{includes}
namespace gouraud::api::checked {{

{bodies}
}}  // namespace gouraud::api::checked
"""


def _checked(command, handlers):
    body = []
    if not families.legal_inside_begin_end(command.name) and command.name != "End":
        nothing = "return;" if command.returns == "void" else "return {};"
        body += [f"if (context.inside_begin_end()) [[unlikely]] {{",
                 f'  reject_inside_begin_end(context, "gl{command.name}");', f"  {nothing}", "}"]
    code = handlers_module.statements(command, handlers)
    if code is None:
        parameters = ", ".join(["Context& context"] + [param.type for param in command.params])
        body += ["static std::atomic_flag said;", f'reject_unimplemented(context, "gl{command.name}", said);']
        body += [] if command.returns == "void" else ["return {};"]
    else:
        parameters = command.parameters(with_context=True)
        body += ["try {", *[f"  {line}" for line in code], "} catch (...) {",
                 f'  report_out_of_memory(context, "gl{command.name}");']
        body += ["}"] if command.returns == "void" else ["  return {};", "}"]
    inline = "[[gnu::always_inline]] inline" if families.family_of(command.name) else "inline"
    lines = "".join(f"  {line}\n" for line in body)
    return f"{inline} {command.returns} {command.name}({parameters}) {{\n{lines}}}\n"


def watched_h(registry):
    rows = "".join(f"{command.returns} {command.name}({command.parameters()});\n"
                   for command in registry.commands.values())
    return f"""{NOTE}\
// The way of a call without a current context, or whose context traces calls, names them in messages, or compiles a
// display list.
#pragma once

#include <GL/gl.h>

namespace gouraud::api::watched {{

{rows}
}}  // namespace gouraud::api::watched
"""


def entry_cpp(registry, commands):
    text = [NOTE, '#include "checked.h"\n#include "watched.h"\n\nnamespace api = gouraud::api;\n']
    for command in commands:
        arguments = command.arguments()
        result = "" if command.returns == "void" else "return "
        leave = f"return api::watched::{command.name}({arguments});"
        text.append(f"""
extern "C" GOURAUD_EXPORT {command.returns} gl{command.name}({command.parameters()}) {{
  api::Context* const context = api::direct_context();
  if (context == nullptr) [[unlikely]] {leave}
  {result}api::checked::{command.name}({command.arguments('*context')});
}}
""")
        for alias in command.aliases:
            text.append(_alias(registry.signatures[alias], command))
    return "".join(text)


def _alias(alias, command):
    """The same symbol under another name; or a call, where types differ in sign (TexImage3DEXT's internalformat)."""
    declared = f"{command.returns} gl{alias.name}({alias.parameters()})"
    if [param.type for param in alias.params] == [param.type for param in command.params]:
        return f'extern "C" GOURAUD_EXPORT __attribute__((alias("gl{command.name}"))) {declared};\n'
    return f'extern "C" GOURAUD_EXPORT {declared} {{ return gl{command.name}({alias.arguments()}); }}\n'


def watched_cpp(commands, handlers):
    text = [NOTE, '#include "watched.h"\n\n#include <algorithm>\n\n'
            '#include "api/registry/call_trace.h"\n#include "checked.h"\n']
    compiles = "NewList" in handlers
    if compiles:
        text.append('#include "records.h"\n')
    text.append("\nnamespace gouraud::api::watched {\n")
    for command in commands:
        nothing = "return;" if command.returns == "void" else "return {};"
        lines = ["Context* const context = current_context();", f"if (context == nullptr) {nothing}"]
        lines.append(f'const ProgramsCall programs_call(*context, "gl{command.name}");')
        lines += _trace_lines(command)
        if compiles and families.recordable(command.name):
            lines += ["if (context->compiling()) {", *[f"  {line}" for line in records.append_lines(command)], "}"]
        result = "" if command.returns == "void" else "return "
        lines.append(f"{result}checked::{command.name}({command.arguments('*context')});")
        body = "".join(f"  {line}\n" for line in lines)
        text.append(f"\n{command.returns} {command.name}({command.parameters()}) {{\n{body}}}\n")
    return "".join(text) + "\n}  // namespace gouraud::api::watched\n"


def _trace_lines(command):
    lines = [f'CallTrace call("gl{command.name}");'] + [_trace_argument(command, param) for param in command.params]
    return ["if (programs_call.traced()) {", *[f"  {line}" for line in lines], "}"]


def _trace_argument(command, param):
    group = f"EnumGroup::{param.group or 'none'}"
    family = families.parameter_family_of(command.name)
    if param.name in ("param", "params") and family:
        add = "add_parameter" if param.is_pointer else "add_scalar"
        return f"call.{add}({handlers_module.shape_function(family)}(pname), {param.name});"
    if param.is_pointer:
        readable = param.type.startswith("const") and param.element != "void" and param.type.count("*") == 1
        if readable and param.length and (param.length.isdigit() or param.length in command.param_names):
            return f"call.add_values({param.name}, {param.length});"
        return f"call.add_pointer({param.name});"
    if param.type == "GLenum":
        return f"call.add_enum({param.name}, {group});"
    if param.type == "GLbitfield":
        return f"call.add_bits({param.name}, {group});"
    if param.type == "GLboolean":
        return f"call.add_boolean({param.name});"
    if param.group == "InternalFormat":
        return f"call.add_enum(static_cast<GLenum>({param.name}), {group});"
    return f"call.add_number({param.name});"


def proc_table_cpp(registry):
    rows = "".join(f'    {{"gl{name}", reinterpret_cast<Proc>(&gl{name})}},\n' for name in sorted(registry.signatures))
    return f"""{NOTE}\
#include <GL/gl.h>

#include "api/registry/proc_address.h"

namespace gouraud::api {{

const NamedProc named_procs[] = {{
{rows}}};
const std::size_t named_proc_count = sizeof(named_procs) / sizeof(named_procs[0]);

}}  // namespace gouraud::api
"""
