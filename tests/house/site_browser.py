# SPDX-License-Identifier: MIT
"""What a browser shows of the site, from files and over http: the first hit of the search for words
that a newcomer would try, formulas, pages as narrow as a telephone, and no request to other machines.
"""
import contextlib
import functools
import http.server
import sys
import threading
from pathlib import Path
from urllib.parse import quote

sys.path.append(str(Path(__file__).resolve().parents[1] / "pages"))
from browser import MISSING, Browser  # noqa: E402, F401

# Words and how the address of their first hit begins.
FIRST_HITS = {
    "negative duals": "docs/answers/negative_duals.html",
    "periodic": "docs/answers/box_without_boundary.html",
    "spectrum": "docs/answers/modes_of_part.html",
    "Neumann": "docs/answers/given_flux.html",
    "Dirichlet": "docs/answers/poisson_on_named_group.html",
    "units": "docs/diagnosis.html#units",
    "install": "docs/installing.html",
    "ParaView": "docs/answers/results_for_paraview.html",
    "geodesic distance": "docs/answers/geodesic_distance.html",
    "cite": "cite.html",
    "Discretization": "cpp/dec-discretization.html#_CPPv4N7polydec14DiscretizationE",
    "march": "cpp/io.html#_CPPv4N7polydec5march",
    "merge_cospherical": "cpp/dec-merging.html#_CPPv4N7polydec17merge_cospherical",
    "polydec::FormSpace": "cpp/dec-boundary.html#_CPPv4N7polydec9FormSpaceE",
    "polydec::PoissonSolver": "cpp/solvers-sources.html#_CPPv4N7polydec13PoissonSolverE",
    "polydec.spectrum": "python.html#polydec.spectrum",
    "poisson": "python.html#polydec.poisson",
    "heat": "python.html#polydec.heat",
    "read_mesh": "python.html#polydec.read_mesh",
    "Mesh": "python.html#polydec.Mesh",
}
NARROW = 390
FORMULAS = ["docs/equations", "docs/metric", "python/notebooks/04_your_own_equation.ipynb"]


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


class Server(http.server.ThreadingHTTPServer):
    def handle_error(self, *_):
        """A page that the browser leaves breaks its connections."""


@contextlib.contextmanager
def served(html):
    """The address of the site over http."""
    handler = functools.partial(Quiet, directory=html)
    with Server(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}"
        server.shutdown()


def wrong_hits(browser, base):
    for word, wanted in FIRST_HITS.items():
        browser.driver.get(f"{base}/search.html?q={quote(word)}")
        browser.wait(lambda: browser.run(
            "return /Results/.test(document.querySelector('#search-results h2')?.innerText)"))
        hit = browser.run("return document.querySelector('ul.search a')?.href") or "nothing"
        if not hit.removeprefix(base + "/").startswith(wanted):
            yield f"search for `{word}`: {hit.removeprefix(base + '/')} before {wanted}"


def lost_formulas(browser, base):
    for page in FORMULAS:
        browser.driver.get(f"{base}/{page}.html")
        browser.driver.execute_async_script(
            "const done = arguments[0], wait = () => !window.MathJax ? done() : MathJax.isReady"
            " ? MathJax.Hub.Queue(() => done()) : setTimeout(wait, 20); wait();")
        formulas, lost = browser.run("""
            const all = [...document.querySelectorAll(".math")];
            return [all.length, all.filter((each) => !each.querySelector(".mjx-chtml")?.offsetWidth
                || each.querySelector(".mjx-merror, .merror")).map((each) => each.textContent)];""")
        if not formulas or lost:
            yield f"{page}.html: {formulas} formulas, not typeset: {lost}"


def wide_pages(browser, base, pages):
    for page in pages:
        browser.driver.get(f"{base}/{page}")
        width = browser.run("return document.documentElement.scrollWidth")
        if width > NARROW:
            yield f"{page}: {width} pixels wide on a screen of {NARROW}"


def complaints_about(html):
    pages = sorted(path.relative_to(html).as_posix() for path in html.rglob("*.html"))
    on_telephone = functools.partial(
        wide_pages, pages=[page for page in pages if not page.startswith("_static/")])
    complaints = []
    wide, narrow = (1200, (wrong_hits, lost_formulas)), (NARROW, (on_telephone,))
    with served(html) as address:
        for base, width, checks in ((f"file://{html}", *wide), (address, *wide),
                                    (f"file://{html}", *narrow)):
            with Browser(width=width) as browser:
                complaints += [f"{base}: {each}" for check in checks
                               for each in check(browser, base)]
                complaints += [f"{base}: asks for {url}" for url in sorted(set(browser.requests()))
                               if not url.startswith((base, "data:", "blob:", "about:"))]
    return complaints
