"""What the specification says about sets of commands, where gl.xml says nothing."""

import re
from dataclasses import dataclass


@dataclass(frozen=True)
class Family:
    """Commands that differ only in the number and type of their values [GL1.5 §2.3].

    One command of the family, the canonical one, has a handler; the others convert to it and inline.
    `fill` holds what stands for each value that a variant does not give.
    """
    name: str
    pattern: str
    canonical: str
    fill: tuple[str, ...]
    conversion: str  # "coordinate": the value itself; "component": by [GL1.5 Table 2.9]; "same": no conversion
    leading: int = 0  # parameters before the values


_POINT = ("0.0f", "0.0f", "0.0f", "1.0f")
_COLOR = ("0.0f", "0.0f", "0.0f", "1.0f")

# [GL1.5 §2.7, §2.6.2, §2.10, §2.13, §5.1]. One and two dimensions of EvalCoord and EvalPoint are different commands.
FAMILIES = (
    Family("Vertex", r"Vertex[234][sifd]v?", "Vertex4f", _POINT, "coordinate"),
    Family("TexCoord", r"TexCoord[1234][sifd]v?", "TexCoord4f", _POINT, "coordinate"),
    Family("MultiTexCoord", r"MultiTexCoord[1234][sifd]v?", "MultiTexCoord4f", _POINT, "coordinate", leading=1),
    Family("Normal", r"Normal3[bsifd]v?", "Normal3f", _POINT[:3], "component"),
    Family("FogCoord", r"FogCoord[fd]v?", "FogCoordf", ("0.0f",), "coordinate"),
    Family("Color", r"Color[34](ub|us|ui|[bsifd])v?", "Color4f", _COLOR, "component"),
    Family("SecondaryColor", r"SecondaryColor3(ub|us|ui|[bsifd])v?", "SecondaryColor3f", _COLOR[:3], "component"),
    Family("Index", r"Index(ub|[sifd])v?", "Indexf", ("0.0f",), "coordinate"),
    Family("EdgeFlag", r"EdgeFlagv?", "EdgeFlag", ("GL_TRUE",), "same"),
    Family("Rect", r"Rect[sifd]v?", "Rectf", _POINT, "coordinate"),
    Family("RasterPos", r"RasterPos[234][sifd]v?", "RasterPos4f", _POINT, "coordinate"),
    Family("WindowPos", r"WindowPos[23][sifd]v?", "WindowPos3f", _POINT[:3], "coordinate"),
    Family("EvalCoord", r"EvalCoord1[fd]v?", "EvalCoord1f", ("0.0f",), "coordinate"),
    Family("EvalCoord", r"EvalCoord2[fd]v?", "EvalCoord2f", ("0.0f", "0.0f"), "coordinate"),
    Family("EvalPoint", r"EvalPoint1", "EvalPoint1", ("0",), "same"),
    Family("EvalPoint", r"EvalPoint2", "EvalPoint2", ("0", "0"), "same"),
)


def family_of(name):
    return next((family for family in FAMILIES if re.fullmatch(family.pattern, name)), None)


# [GL1.5 §2.6.3]: every other command raises GL_INVALID_OPERATION between Begin and End. End itself is not of the list,
# but must of course pass.
_INSIDE_BEGIN_END = re.compile(
    r"(Vertex|Color|SecondaryColor|Normal|TexCoord|MultiTexCoord)[1234].*|(Index|FogCoord)(ub|[sifd])v?|EdgeFlagv?|"
    r"ArrayElement|EvalCoord[12][fd]v?|EvalPoint[12]|Material[fi]v?|CallLists?")


def legal_inside_begin_end(name):
    return _INSIDE_BEGIN_END.fullmatch(name) is not None


# [GL1.5 §5.4]: what is executed at once while a list is being compiled. NewList and EndList bound the list.
_NOT_COMPILED = re.compile(
    r"(Gen|Delete|Get|Is)[A-Z].*|FeedbackBuffer|SelectBuffer|RenderMode|ReadPixels|PixelStore[fi]|AreTexturesResident|"
    r"(Color|FogCoord|EdgeFlag|Index|Normal|TexCoord|SecondaryColor|Vertex)Pointer(EXT)?|InterleavedArrays|"
    r"ClientActiveTexture|(Enable|Disable)ClientState|(Push|Pop)ClientAttrib|(Lock|Unlock)ArraysEXT|"
    r"(Bind|Check)(Framebuffer|Renderbuffer)\w*|Framebuffer(Renderbuffer|Texture)\w*|RenderbufferStorage\w*|"
    r"GenerateMipmap|BindBuffer|BufferData|BufferSubData|MapBuffer|UnmapBuffer|Flush|Finish|NewList|EndList")


def recordable(name):
    return _NOT_COMPILED.fullmatch(name) is None


@dataclass(frozen=True)
class ParameterFamily:
    """Commands of the form Name{f,i,d}[v](..., pname, param): the handler is `Name`fv.

    The scalar forms accept only the parameters of one value, else GL_INVALID_ENUM [GL1.5 §2.14.2]; integers convert
    directly, but colours by [GL1.5 Table 2.9]. A pname that is not listed here is GL_INVALID_ENUM in every form but fv,
    and has no values in a display list.
    """
    name: str
    types: str
    colors: str  # four values each
    vectors: dict[str, int]
    scalars: str
    enums: str = ""  # scalars whose value is itself an enum: traces print its name


PARAMETER_FAMILIES = (
    ParameterFamily("Light", "fi", "AMBIENT DIFFUSE SPECULAR", {"POSITION": 4, "SPOT_DIRECTION": 3},
                    "SPOT_EXPONENT SPOT_CUTOFF CONSTANT_ATTENUATION LINEAR_ATTENUATION QUADRATIC_ATTENUATION"),
    ParameterFamily("LightModel", "fi", "LIGHT_MODEL_AMBIENT", {}, "LIGHT_MODEL_LOCAL_VIEWER LIGHT_MODEL_TWO_SIDE",
                    "LIGHT_MODEL_COLOR_CONTROL"),
    ParameterFamily("Material", "fi", "AMBIENT DIFFUSE SPECULAR EMISSION AMBIENT_AND_DIFFUSE", {"COLOR_INDEXES": 3},
                    "SHININESS"),
    ParameterFamily("Fog", "fi", "FOG_COLOR", {}, "FOG_DENSITY FOG_START FOG_END FOG_INDEX", "FOG_MODE FOG_COORD_SRC"),
    ParameterFamily("PointParameter", "fi", "", {"POINT_DISTANCE_ATTENUATION": 3},
                    "POINT_SIZE_MIN POINT_SIZE_MAX POINT_FADE_THRESHOLD_SIZE"),
    ParameterFamily("TexEnv", "fi", "TEXTURE_ENV_COLOR", {}, "RGB_SCALE ALPHA_SCALE TEXTURE_LOD_BIAS COORD_REPLACE_ARB",
                    "TEXTURE_ENV_MODE COMBINE_RGB COMBINE_ALPHA SRC0_RGB SRC1_RGB SRC2_RGB SRC0_ALPHA SRC1_ALPHA "
                    "SRC2_ALPHA OPERAND0_RGB OPERAND1_RGB OPERAND2_RGB OPERAND0_ALPHA OPERAND1_ALPHA OPERAND2_ALPHA"),
    ParameterFamily("TexGen", "fid", "", {"OBJECT_PLANE": 4, "EYE_PLANE": 4}, "", "TEXTURE_GEN_MODE"),
    ParameterFamily("TexParameter", "fi", "TEXTURE_BORDER_COLOR", {},
                    "TEXTURE_PRIORITY TEXTURE_MIN_LOD TEXTURE_MAX_LOD TEXTURE_BASE_LEVEL TEXTURE_MAX_LEVEL "
                    "TEXTURE_LOD_BIAS GENERATE_MIPMAP TEXTURE_MAX_ANISOTROPY_EXT",
                    "TEXTURE_WRAP_S TEXTURE_WRAP_T TEXTURE_WRAP_R TEXTURE_MIN_FILTER TEXTURE_MAG_FILTER "
                    "DEPTH_TEXTURE_MODE TEXTURE_COMPARE_MODE TEXTURE_COMPARE_FUNC"),
)


def parameter_family_of(name):
    """The family of Lightf, Lightfv, Lighti, ...; None for every other command."""
    matches = (family for family in PARAMETER_FAMILIES if re.fullmatch(f"{family.name}[{family.types}]v?", name))
    return next(matches, None)


# The other commands that only convert their arguments: command -> (canonical command, its arguments).
# Matrices are kept in float, so double arguments lose nothing that would be kept [GL1.5 §2.11.2].
DERIVED = {
    "LoadMatrixd": ("LoadMatrixf", "to_float_matrix(m).data()"),
    "MultMatrixd": ("MultMatrixf", "to_float_matrix(m).data()"),
    "LoadTransposeMatrixf": ("LoadMatrixf", "transposed(m).data()"),
    "LoadTransposeMatrixd": ("LoadMatrixf", "transposed(m).data()"),
    "MultTransposeMatrixf": ("MultMatrixf", "transposed(m).data()"),
    "MultTransposeMatrixd": ("MultMatrixf", "transposed(m).data()"),
    "Rotated": ("Rotatef", "to_float(angle), to_float(x), to_float(y), to_float(z)"),
    "Scaled": ("Scalef", "to_float(x), to_float(y), to_float(z)"),
    "Translated": ("Translatef", "to_float(x), to_float(y), to_float(z)"),
    "MapGrid1d": ("MapGrid1f", "un, to_float(u1), to_float(u2)"),
    "MapGrid2d": ("MapGrid2f", "un, to_float(u1), to_float(u2), vn, to_float(v1), to_float(v2)"),
    "PixelStoref": ("PixelStorei", "pname, pixel_store_value(pname, param)"),
    "PixelTransferi": ("PixelTransferf", "pname, to_float(param)"),
}
