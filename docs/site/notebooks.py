# SPDX-License-Identifier: MIT
"""Pages of executed notebooks: text, code, and the results with pictures and interactive pages."""
import base64
import html
import os
import re

import nbclient
import nbformat

# The debugger of IPython's kernel warns without it.
os.environ["PYDEVD_DISABLE_FILE_VALIDATION"] = "1"
FRAME = re.compile(r'<iframe srcdoc="([^"]*)"')


def result(output, place, pages, heading):
    """The Markdown of a result; pictures go beside `place`, interactive pages into `pages`."""
    data = output.get("data", {})
    if "image/png" in data:
        picture = place.with_suffix(".png")
        picture.write_bytes(base64.b64decode(data["image/png"]))
        return f"![{heading}]({picture.name})"
    frame = FRAME.match(data.get("text/html", ""))
    if frame:
        pages.mkdir(parents=True, exist_ok=True)
        page = pages / f"{place.name}.html"
        page.write_text(html.unescape(frame.group(1)))
        return ('```{raw} html\n<iframe class="viewer" loading="lazy" title="' + heading
                + f'" src="../../_static/{pages.name}/{page.name}"></iframe>\n```')
    text = output.get("text") or data.get("text/plain", "")
    # An object without a text of its own says nothing.
    return "" if re.match(r"<.* at 0x", text) else f"```none\n{text.rstrip()}\n```"


def page(path, folder, pages):
    """The Markdown of a notebook, run in `folder`, where its pictures stay."""
    notebook = nbformat.read(path, 4)
    folder.mkdir(parents=True, exist_ok=True)
    nbclient.NotebookClient(notebook, timeout=300,
                            resources={"metadata": {"path": str(folder)}}).execute()
    parts, heading = [], path.stem
    for cell in notebook.cells:
        if cell.cell_type == "markdown":
            heading = (re.findall(r"^#+ (.*)", cell.source, re.M) or [heading])[-1]
            parts.append(cell.source)
            continue
        parts.append(f"```python\n{cell.source}\n```")
        parts += [result(output, folder / f"{path.stem}-{len(parts)}-{i}", pages,
                         heading.replace("`", ""))
                  for i, output in enumerate(cell.outputs)]
    return "\n\n".join(filter(None, parts)) + "\n"
