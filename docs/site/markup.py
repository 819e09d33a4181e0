# SPDX-License-Identifier: MIT
"""Turns comments and docstrings, which are plain text with `code`, into reStructuredText."""
import re


def inline(text):
    """The text with its code marked and all other signs escaped."""
    parts = re.split(r"(``[^`]+``|`[^`]+`)", text)
    for i, part in enumerate(parts):
        if i % 2:
            parts[i] = f"``{' '.join(part.strip('`').split())}``\\ "
        else:
            parts[i] = re.sub(r"([\\*|`]|_\b)", r"\\\1", part)
    return "".join(parts)


def docstring(text):
    """A docstring in numpy's style; dialogs stay as they are."""
    parts = re.split(r"((?:^ *(?:>>>|\.\.\.).*\n(?:^ *\S.*\n)*)+)", text + "\n", flags=re.M)
    return "".join(part if i % 2 else inline(part) for i, part in enumerate(parts))


def comment(element):
    """The text of a description that doxygen wrote."""
    def flat(node):
        text = (node.text or "") + "".join(flat(child) + (child.tail or "") for child in node)
        if node.tag == "computeroutput":
            return f"`{text}`"
        return {"para": "\n\n{}\n\n", "listitem": "\n\n{}\n\n", "verbatim": "`{}`",
                "linebreak": "\n"}.get(node.tag, "{}").format(text.strip("\n"))
    blocks = [" ".join(block.split()) for block in re.split(r"\n\s*\n", flat(element))]
    # The first sign is hidden, since it may begin a list or a field.
    return "\n\n".join("\\ " + inline(block) for block in blocks if block)
