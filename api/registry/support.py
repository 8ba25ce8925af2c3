"""Writes the README's table of what is implemented, by section of the GL 1.5 specification."""

import re

import families
import handlers as handlers_module

BEGIN, END = "<!-- support:begin -->", "<!-- support:end -->"

# Section, title, and its commands without GL's type suffixes where a pattern covers them.
SECTIONS = (
    ("2.5", "Errors", "GetError"),
    ("2.6", "Begin and End", "Begin|End|EdgeFlagv?"),
    ("2.7", "Vertex specification", r"(Vertex|Color|SecondaryColor|Normal|TexCoord|MultiTexCoord)\d.*|"
                                    r"(Index|FogCoord)(ub|[sifd])v?"),
    ("2.8", "Vertex arrays", r".*Pointer|(Enable|Disable)ClientState|ClientActiveTexture|ArrayElement|"
                             r"(Multi)?Draw(Range)?(Arrays|Elements)|InterleavedArrays"),
    ("2.9", "Buffer objects", "(Bind|Gen|Delete|Map|Unmap)Buffers?|Buffer(Sub)?Data"),
    ("2.10", "Rectangles", "Rect.*"),
    ("2.11", "Transformations", r"DepthRange|Viewport|MatrixMode|(Load|Mult)(Transpose)?Matrix[fd]|LoadIdentity|"
                                r"(Rotate|Translate|Scale)[fd]|Frustum|Ortho|(Push|Pop)Matrix|ActiveTexture|TexGen.*"),
    ("2-4", "Enables", "Enable|Disable|IsEnabled"),
    ("2.12", "Clip planes", "ClipPlane"),
    ("2.13", "Raster position", "(RasterPos|WindowPos).*"),
    ("2.14", "Lighting and colours", "FrontFace|Material.*|Light.*|ColorMaterial|ShadeModel"),
    ("3.2", "Multisampling", "SampleCoverage"),
    ("3.3", "Points", "PointSize|PointParameter.*"),
    ("3.4", "Lines", "LineWidth|LineStipple"),
    ("3.5", "Polygons", "CullFace|PolygonStipple|PolygonMode|PolygonOffset"),
    ("3.6", "Pixel rectangles", "Pixel.*|DrawPixels"),
    ("3.7", "Bitmaps", "Bitmap"),
    ("3.8", "Texturing", "(Copy|Compressed)?Tex(Sub)?Image.*|(Copy|Compressed)TexSubImage.*|TexParameter.*|TexEnv.*|"
                         "(Bind|Gen|Delete|Prioritize)Textures?|AreTexturesResident"),
    ("3.10", "Fog", "Fog[if]v?"),
    ("4.1.2", "Scissor", "Scissor"),
    ("4.1.4", "Alpha test", "AlphaFunc"),
    ("4.1.5", "Stencil test", "StencilFunc|StencilOp"),
    ("4.1.6", "Depth test", "DepthFunc"),
    ("4.1.7", "Occlusion queries", "(Gen|Delete)Queries|(Begin|End)Query"),
    ("4.1.8", "Blending", "Blend.*"),
    ("4.1.10", "Logic op", "LogicOp"),
    ("4.2", "Whole framebuffer", "DrawBuffer|(Color|Index|Depth|Stencil)Mask|Clear.*|Accum"),
    ("4.3", "Reading and copying pixels", "ReadPixels|ReadBuffer|CopyPixels"),
    ("5.1", "Evaluators", "Map[12].*|MapGrid.*|Eval.*"),
    ("5.2", "Selection", "InitNames|(Load|Pop|Push)Name|SelectBuffer|RenderMode"),
    ("5.3", "Feedback", "FeedbackBuffer|PassThrough"),
    ("5.4", "Display lists", "NewList|EndList|CallLists?|ListBase|GenLists|DeleteLists"),
    ("5.5, 5.6", "Flush, finish, hints", "Flush|Finish|Hint"),
    ("6.1", "Queries", "Get.*|Is.*"),
    ("6.1.14", "Attribute stacks", "(Push|Pop)(Client)?Attrib"),
)


def section_of(name):
    """The index in SECTIONS of the first section that a command belongs to."""
    return next(i for i, (_, _, pattern) in enumerate(SECTIONS) if re.fullmatch(pattern, name))


def markdown(registry, handlers):
    by_section = {}
    for command in registry.core:
        by_section.setdefault(section_of(command.name), []).append(command)
    lines = ["| GL 1.5 | section | commands | written | missing |", "|---|---|--:|--:|---|"]
    total = written = 0
    for i, (number, title, _) in enumerate(SECTIONS):
        commands = by_section[i]
        missing = [command.name for command in commands if handlers_module.statements(command, handlers) is None]
        total, written = total + len(commands), written + len(commands) - len(missing)
        lines.append(f"| §{number} | {title} | {len(commands)} | {len(commands) - len(missing)} | "
                     f"{', '.join(_abbreviate(missing)) or 'none: complete'} |")
    lines.append(f"| | all | {total} | {written} | {total - written} |")
    extensions = [section.name for section in registry.sections if section.advertised]
    names = ", ".join(name for name in extensions if not name.startswith("GL_VERSION"))
    return "\n".join(lines) + f"\n\nExtensions: {names or 'none yet'}.\n"


def _abbreviate(names):
    """Typed variants of one family under the family's name."""
    groups = {}
    for name in names:
        family = families.family_of(name) or families.parameter_family_of(name)
        groups.setdefault(family.name + "*" if family and family.name != name else name, []).append(name)
    return [group if len(members) > 1 else members[0] for group, members in groups.items()]


def update(readme, table):
    """Replaces what stands between the two marker lines of a file."""
    text = readme.read_text()
    if BEGIN not in text or END not in text:
        raise SystemExit(f"{readme}: no lines {BEGIN} and {END}")
    head, rest = text.split(BEGIN, 1)
    tail = rest.split(END, 1)[1]
    readme.write_text(f"{head}{BEGIN}\n{table}{END}{tail}")
