#!/usr/bin/env python3
"""Checks that every citation [GL1.5 ...] in the sources names sections and tables that the specification has.

A citation stands on one line and lists, with commas or "and": §2.14.1 · §2.14.1 eq 2.3 · §3.9-4.2 or §3.9 to §4.2 ·
Table 2.10 · Tables 6.8, 6.9 and 6.11 · Tables 6.28 to 6.31 · App. A · ch. 6. Equations must belong to the chapter of
their section. A string that begins with § is held to the same rules. Also lists the sections of chapters 2 to 6 that
nobody cites; that is no complaint.
"""
import re
import sys

import sources

CITATION = re.compile(r'\[GL1\.5(?P<body>[^\]"\n]*)(?P<end>[\]"]?)')
LITERAL = re.compile(r'"(?P<body>§ ?\d[^"\n]*)(?P<end>")')  # what a plan's line or a scene cites at run time
SECTION = r"[0-9A-I](?:\.\d+)*"
TABLE = r"[0-9A-I]\.\d+"
UNTIL = r"(?:[-–]| to )§?"
ITEM = re.compile(rf"§(?P<sections>{SECTION}(?:{UNTIL}{SECTION})?)"
                  rf"(?: eqs? (?P<equations>\d+\.\d+(?:(?:{UNTIL}| and |, )\d+\.\d+)*))?"
                  rf"|Tables? (?P<tables>{TABLE}(?:(?:{UNTIL}| and |, ){TABLE})*)"
                  rf"|(?:App\.|ch\.) (?P<chapter>{SECTION})")
SEPARATOR = re.compile(r"[,;] | and | (?=Table )")
ENDINGS = sources.CPP + (".py", ".txt", ".md", ".sh")


def read_specification():
    """The titles of all sections and of all tables, by their numbers."""
    sections, tables = {}, {}
    for line in sources.read(".ci/gl15_sections.txt").splitlines():
        if line.startswith("Table "):
            _, number, title = line.split(" ", 2)
            tables[number] = title
        elif not line.startswith("#"):
            number, title = line.split(" ", 1)
            sections[number] = title
    return sections, tables


def errors_in_citation(body, sections, tables, cited):
    """What is wrong with the text of a citation; adds the sections it names to `cited`."""
    errors, place = [], 0
    while True:
        item = ITEM.match(body, place)
        if not item:
            return errors + [f"'{body[place:]}' is not understood"]
        named = re.findall(SECTION, item["sections"] or item["chapter"] or "")
        cited.update(named)
        errors += [f"there is no section {number}" for number in named if number not in sections]
        errors += [f"there is no Table {number}" for number in re.findall(TABLE, item["tables"] or "")
                   if number not in tables]
        errors += [f"equation {number} does not belong to the chapter of §{named[0]}"
                   for number in re.findall(TABLE, item["equations"] or "") if number[0] != named[0][0]]
        place = item.end()
        if place == len(body):
            return errors
        separator = SEPARATOR.match(body, place)
        if not separator:
            return errors + [f"'{body[place:]}' is not understood"]
        place = separator.end()


def main():
    sections, tables = read_specification()
    complaints, cited, count = [], set(), 0
    for room in sources.ROOMS:
        for path in sources.files(room, ENDINGS):
            for number, line in enumerate(sources.read(path).splitlines(), 1):
                for citation in [*CITATION.finditer(line), *LITERAL.finditer(line)]:
                    if citation["end"] == '"' and not citation["body"].strip():
                        continue  # the rest is put together at run time
                    count += 1
                    where = f"{path}:{number}: {citation.group()}"
                    if not citation["end"]:
                        complaints.append(f"{where}: does not end on its line")
                        continue
                    complaints += [f"{where}: {error}" for error in
                                   errors_in_citation(citation["body"].strip(), sections, tables, cited)]
    uncited = [n for n in sections if n[0] in "23456" and "." in n and n not in cited]
    print("Sections of chapters 2 to 6 that no source cites:")
    for number in uncited:
        print(f"  §{number} {sections[number]}")
    return sources.report("check_citations", complaints,
                          f"{count} citations, all valid; {len(uncited)} sections cited by nobody")


if __name__ == "__main__":
    sys.exit(main())
