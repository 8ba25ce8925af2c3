"""Reads the Khronos gl.xml: the commands and enums of GL 1.0-1.5 and of the extensions listed in extensions.txt."""

import re
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field
from pathlib import Path

LAST_VERSION = "1.5"

# Names that gl.xml keeps outside GL 1.0-1.5: the specification's Table 2.3 has the first; the second is the spelling
# that every GL header has had since 1.1.
EXTRA_ENUMS = {"GL_TABLE_TOO_LARGE": None, "GL_ALL_CLIENT_ATTRIB_BITS": 0xFFFFFFFF}

# Other names of core commands that gl.xml does not call aliases, since their GLX protocol differs.
EXTRA_ALIASES = {
    "AreTexturesResidentEXT": "AreTexturesResident", "DeleteTexturesEXT": "DeleteTextures",
    "GenTexturesEXT": "GenTextures", "IsTextureEXT": "IsTexture",
}


# What we offer of later versions without offering those versions: (name of the section, enums, commands). Programs that
# look for extensions one by one find them so, whatever the version.
EXTRA_SECTIONS = (
    ("GL_GOURAUD_get_stringi", ("GL_NUM_EXTENSIONS",), ("GetStringi",)),
    ("GL_GOURAUD_get_integer64", (), ("GetInteger64v",)),
)


@dataclass(frozen=True)
class Param:
    name: str
    type: str  # as in C, one space before '*': "const GLfloat *"
    group: str | None  # gl.xml's name of the set of enums that the parameter takes
    length: str | None  # gl.xml's length of what a pointer points to: "4", "n", "COMPSIZE(pname)"

    @property
    def is_pointer(self):
        return "*" in self.type

    @property
    def element(self):
        """The type pointed to, without const: "GLfloat"."""
        return self.type.replace("const", "").replace("*", "", 1).strip()

    def declare(self):
        return self.type + ("" if self.type.endswith("*") else " ") + self.name


@dataclass(frozen=True)
class Command:
    name: str  # without the prefix gl
    returns: str
    params: tuple[Param, ...]
    source: str  # GL_VERSION_1_3 or an extension's name
    aliases: tuple[str, ...] = ()  # further names of the same command, listed by supported extensions

    @property
    def param_names(self):
        return [param.name for param in self.params]

    def parameters(self, with_context=False):
        declared = ["Context& context"] * with_context + [param.declare() for param in self.params]
        return ", ".join(declared) or "void"

    def arguments(self, context=None):
        return ", ".join([context] * (context is not None) + self.param_names)


@dataclass(frozen=True)
class Enum:
    name: str
    value: int
    groups: frozenset[str]
    source: str


@dataclass(frozen=True)
class Section:
    """What one GL version or one extension adds to the header."""
    name: str
    enums: tuple[str, ...]
    commands: tuple[str, ...]  # without the prefix gl, aliases included
    advertised: bool


@dataclass
class Registry:
    sections: list[Section] = field(default_factory=list)
    enums: dict[str, Enum] = field(default_factory=dict)
    commands: dict[str, Command] = field(default_factory=dict)  # core commands first
    signatures: dict[str, Command] = field(default_factory=dict)  # every name that the header declares
    bitmasks: set[str] = field(default_factory=set)

    @property
    def core(self):
        return [command for command in self.commands.values() if command.source.startswith("GL_VERSION")]


@dataclass(frozen=True)
class Listed:
    advertised: bool
    same_as: str | None = None  # the extension that it is another name of


def read_extension_list(path):
    """{name: Listed}; a line is a name, the word `works` behind it where GL_EXTENSIONS shall list it, and `as` with another
    extension's name where gl.xml does not have it but the other."""
    extensions = {}
    for line in Path(path).read_text().splitlines():
        name, *words = line.split("#")[0].split() or [None]
        if name:
            same_as = words[words.index("as") + 1] if "as" in words else None
            extensions[name] = Listed("works" in words, same_as)
    return extensions


def read_registry(xml_path, extensions):
    root = ElementTree.parse(xml_path).getroot()
    xml_commands = {node.find("proto/name").text: node for node in root.find("commands")}
    xml_enums = {}
    for node in root.iter("enum"):
        if node.get("value") is not None and node.get("api") in (None, "gl"):
            xml_enums.setdefault(node.get("name"), node)

    registry = Registry()
    registry.bitmasks = {node.get("group") for node in root.findall("enums") if node.get("type") == "bitmask"}
    for name, advertised, node in _sources(root, extensions):
        _add_section(registry, name, advertised, node, xml_commands, xml_enums)
    for name, enums, commands in EXTRA_SECTIONS:
        _add_names(registry, name, False, enums, commands, xml_commands, xml_enums)
    _fold_aliases(registry, xml_commands)
    return registry


def _sources(root, extensions):
    for node in root.findall("feature"):
        if node.get("api") == "gl" and node.get("number") <= LAST_VERSION:
            yield node.get("name"), True, node
    nodes = {node.get("name"): node for node in root.find("extensions")}
    for name, listed in extensions.items():
        if listed.same_as is not None and listed.same_as not in extensions:
            raise SystemExit(f"extensions.txt: {name} is said to be {listed.same_as}, which is not there")
        if name not in nodes and listed.same_as is None:
            raise SystemExit(f"extensions.txt: gl.xml has no {name}")
        yield name, listed.advertised, nodes.get(listed.same_as or name)


def _add_section(registry, name, advertised, node, xml_commands, xml_enums):
    required = [item for block in node.findall("require") if block.get("api") in (None, "gl") for item in block]
    enums = [item.get("name") for item in required if item.tag == "enum"]
    if name == "GL_VERSION_1_1":
        enums += EXTRA_ENUMS
    commands = [item.get("name")[2:] for item in required if item.tag == "command"]
    _add_names(registry, name, advertised, enums, commands, xml_commands, xml_enums)


def _add_names(registry, name, advertised, enums, commands, xml_commands, xml_enums):
    enums = [enum for enum in dict.fromkeys(enums) if enum not in registry.enums]
    for enum in enums:
        xml = xml_enums.get(enum)
        value = int(xml.get("value"), 0) if xml is not None else EXTRA_ENUMS[enum]
        groups = frozenset(xml.get("group", "").split(",")) - {""} if xml is not None else frozenset()
        registry.enums[enum] = Enum(enum, value, groups, name)
    names = [command for command in dict.fromkeys(commands) if command not in registry.signatures]
    for command in names:
        registry.signatures[command] = _read_command(xml_commands["gl" + command], name)
    registry.sections.append(Section(name, tuple(enums), tuple(names), advertised))


def _read_command(node, source):
    params = []
    for param in node.findall("param"):
        name = param.find("name").text
        params.append(Param(name, _type_of(param), param.get("group"), param.get("len")))
    proto = node.find("proto")
    return Command(proto.find("name").text[2:], _type_of(proto), tuple(params), source)


def _type_of(node):
    text = "".join(node.itertext()).removesuffix(node.find("name").text)
    return re.sub(r"\s*\*", " *", " ".join(text.split())).replace("* *", "**")


def _fold_aliases(registry, xml_commands):
    """Makes a command that gl.xml calls an alias of another one we have a further name of that one."""
    primary = {}
    for name in registry.signatures:
        primary[name] = _alias_root(name, registry, xml_commands)
    for name, command in registry.signatures.items():
        if primary[name] == name:
            aliases = tuple(alias for alias, root in primary.items() if root == name and alias != name)
            registry.commands[name] = Command(name, command.returns, command.params, command.source, aliases)


def _alias_root(name, registry, xml_commands):
    if name in EXTRA_ALIASES:
        return EXTRA_ALIASES[name]
    seen = name
    while True:
        alias = xml_commands["gl" + seen].find("alias")
        if alias is None:
            break
        seen = alias.get("name")[2:]
    if seen in registry.signatures:
        return seen
    # The target itself is not in our set: the first listed name that shares it stands for all.
    for other in registry.signatures:
        alias = xml_commands["gl" + other].find("alias")
        if alias is not None and alias.get("name")[2:] == seen:
            return other
    return name
