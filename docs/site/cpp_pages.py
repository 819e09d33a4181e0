# SPDX-License-Identifier: MIT
"""Pages of the C++ interface: one for each folder, with a section for each public header."""
import re
import subprocess
import textwrap
import xml.etree.ElementTree as xml
from collections import defaultdict

import markup

DOXYFILE = """INPUT = {inputs}
OUTPUT_DIRECTORY = {out}
STRIP_FROM_PATH = {root}
GENERATE_HTML = NO
GENERATE_LATEX = NO
GENERATE_XML = YES
XML_PROGRAMLISTING = NO
EXTRACT_ALL = YES
HAVE_DOT = NO
QUIET = YES
WARNINGS = NO
"""


def public_headers(root):
    """The headers that polydec.h includes, directly or not, and those of the components."""
    def includes(header):
        return re.findall(r'^#include "([^"]+)"', (root / header).read_text(), re.M)
    found, open_ends = set(), ["polydec.h"]
    open_ends += [f"backends/{name}" for name in
                  ("linear/cholmod.h", "linear/petsc.h", "eigen/slepc.h")]
    block = re.search(r"FILE_SET HEADERS[^)]*FILES([^)]*)\)",
                      (root / "distributed/CMakeLists.txt").read_text()).group(1)
    open_ends += [f"distributed/{name}" for name in block.split()]
    while open_ends:
        header = open_ends.pop()
        if header not in found:
            found.add(header)
            open_ends += includes(header)
    return sorted(found)


def directive(kind, signatures, text, inner=""):
    head = f".. cpp:{kind}:: " + ("\n" + " " * (len(kind) + 12)).join(signatures)
    body = "\n\n".join(part for part in (text, inner) if part)
    return head + "\n\n" + textwrap.indent(body, "   ") + "\n"


def described(node):
    return "\n\n".join(filter(None, (markup.comment(node.find(name)) for name in
                                     ("briefdescription", "detaileddescription"))))


def template(node):
    parameters = node.find("templateparamlist")
    if parameters is None:
        return ""
    def words(parameter):
        default = parameter.find("defval")
        return " ".join(filter(None, (
            "".join(parameter.find("type").itertext()), parameter.findtext("declname"),
            "= " + "".join(default.itertext()) if default is not None else "")))
    return "template<" + ", ".join(words(parameter) for parameter in parameters) + "> "


def signature(member, owner):
    """Kind and declaration of a member in Sphinx' words, its name without the type around it."""
    def short(text):
        return re.sub(re.escape(owner) + r"(< [^<>]*>)?::", "", text) if owner else text
    kind, name = member.get("kind"), short(member.findtext("qualifiedname"))
    definition = short(member.findtext("definition") or "")
    if kind == "function":
        tail = re.sub(r"\s*=\s*(0|default|delete)$", r" = \1",
                      member.findtext("argsstring") or "()")
        return kind, template(member) + re.sub(r"^friend ", "", definition) + tail
    if kind == "enum":
        return ("enum-class" if member.get("strong") == "yes" else "enum"), name
    if kind == "typedef":
        return "type", template(member) + re.sub(r"\b(using|typedef) ", "", definition)
    return "var", template(member) + definition


def members(nodes, seen, source, owner=""):
    """Directives for members. One without a comment joins the line above it, if there is one."""
    items = []
    for node in nodes:
        if node.get("prot") == "private" or node.get("kind") not in (
                "function", "enum", "typedef", "variable"):
            continue
        kind, declaration = signature(node, owner)
        if not node.findtext("name") or "::detail::" in declaration or (owner, declaration) in seen:
            continue
        seen.add((owner, declaration))
        text, line = described(node), int(node.find("location").get("line"))
        values = "\n".join(directive("enumerator", [value.findtext("name")], described(value))
                           for value in node.findall("enumvalue"))
        if items and not text and not values and items[-1][0] == kind \
                and source[line - 2].strip():
            items[-1][1].append(declaration)
        else:
            items.append([kind, [declaration], text, values])
    return "\n".join(directive(*item) for item in items)


def write(root, out, scratch):
    headers = public_headers(root)
    scratch.mkdir(parents=True)
    subprocess.run(["doxygen", "-"], check=True, text=True, stdout=subprocess.DEVNULL,
                   input=DOXYFILE.format(inputs=" ".join(f"{root}/{name}" for name in headers),
                                         out=scratch, root=root))
    types, free = defaultdict(list), defaultdict(list)
    for path in sorted((scratch / "xml").glob("*.xml")):
        for compound in xml.parse(path).getroot().findall("compounddef"):
            kind, place = compound.get("kind"), compound.find("location")
            if kind in ("class", "struct"):
                types[place.get("file")].append((int(place.get("line")), compound))
            elif kind in ("namespace", "file"):
                for node in compound.iter("memberdef"):
                    where = node.find("location")
                    file = where.get("declfile") or where.get("file")
                    free[file].append((int(where.get("declline") or where.get("line")), node))
    seen, folders = set(), defaultdict(list)
    for header in headers:
        folders[header.rpartition("/")[0] or "polydec.h"].append(header)
    out.mkdir(parents=True)
    for folder, names in folders.items():
        page = [f"{folder}\n{'=' * len(folder)}\n"]
        for header in names:
            source = (root / header).read_text().splitlines()
            page.append(f"{header}\n{'-' * len(header)}\n\n``#include \"{header}\"``\n")
            for _, compound in sorted(types[header], key=lambda item: item[0]):
                name = compound.findtext("compoundname")
                if compound.get("prot") == "private" or name in seen \
                        or re.search("::(internal|detail)::", name):
                    continue
                seen.add(name)
                page.append(directive(compound.get("kind"), [template(compound) + name],
                                      described(compound),
                                      members(compound.iter("memberdef"), seen, source, name)))
            nodes = [node for _, node in sorted(free[header], key=lambda item: item[0])]
            page.append(members(nodes, seen, source))
            if not types[header] and not nodes:
                included = re.findall(r'^#include "([^"]+)"', "\n".join(source), re.M)
                page.append("Includes " + ", ".join(f"``{name}``" for name in included) + ".\n")
        (out / (folder.replace("/", "-") + ".rst")).write_text("\n".join(page))
    names = sorted(path.stem for path in out.glob("*.rst"))
    (out / "index.rst").write_text("C++\n===\n\n.. toctree::\n   :maxdepth: 2\n\n   "
                                   + "\n   ".join(names) + "\n")
