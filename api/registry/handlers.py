"""Finds the handlers in api/commands/*.h, and says how each command reaches one."""

import re
from pathlib import Path

import families

_COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
_HANDLER = re.compile(r"\b([A-Z]\w*)\s*\(\s*(?:\w+::)*Context\s*&\s*\w*\s*[,)]")


def find_handlers(folder, commands):
    """{command: header's file name} of every handler declared as `Type Name(Context& context, ...)`."""
    handlers = {}
    for header in sorted(Path(folder).glob("*.h")):
        text = _COMMENT.sub("", header.read_text())
        for match in _HANDLER.finditer(text):
            if match.group(1) in commands:
                handlers.setdefault(match.group(1), header.name)
    return handlers


def statements(command, handlers):
    """The C++ statements that carry out `command` through its own handler or its family's; None if neither exists."""
    if command.name in handlers:
        return [_call(command, command.name, command.arguments())]
    for build in (_family_call, _parameter_call, _derived_call):
        result = build(command, handlers)
        if result is not None:
            return result
    return None


def _call(command, handler, arguments):
    prefix = "" if command.returns == "void" else "return "
    return f"{prefix}api::{handler}(context{', ' + arguments if arguments else ''});"


def _family_call(command, handlers):
    family = families.family_of(command.name)
    if family is None or family.canonical not in handlers:
        return None
    leading = [param.name for param in command.params[:family.leading]]
    return [_call(command, family.canonical, ", ".join(leading + family_values(command, family)))]


def family_values(command, family, prefix=""):
    """The values of a family's command as C++ expressions, converted and filled up for its canonical command."""
    values = []
    for param in command.params[family.leading:]:
        if param.is_pointer:
            values += [f"{prefix}{param.name}[{i}]" for i in range(int(param.length))]
        else:
            values.append(prefix + param.name)
    convert = {"coordinate": "to_float({})", "component": "to_component({})", "same": "{}"}[family.conversion]
    values = [convert.format(value) for value in values]
    return values + list(family.fill[len(values):])


def _parameter_call(command, handlers):
    family = families.parameter_family_of(command.name)
    if family is None or family.name + "fv" not in handlers:
        return None
    is_vector = command.params[-1].is_pointer
    *leading, value = [param.name for param in command.params]
    refuse = "shape.values == 0" if is_vector else "shape.values != 1"
    return [
        f"const ParameterShape shape = {shape_function(family)}(pname);",
        f'if ({refuse}) return reject_parameter(context, "gl{command.name}");',
        f"const auto values = to_parameter(shape, {'' if is_vector else '&'}{value});",
        _call(command, family.name + "fv", ", ".join(leading + ["values.data()"])),
    ]


def shape_function(family):
    return "shape_of_" + re.sub(r"(?<!^)([A-Z])", r"_\1", family.name).lower()


def _derived_call(command, handlers):
    canonical, arguments = families.DERIVED.get(command.name, (None, None))
    return [_call(command, canonical, arguments)] if canonical in handlers else None
