# SPDX-License-Identifier: MIT
"""What tests of pages in a browser share; without a browser they are skipped."""
import sys

from browser import MISSING, Browser
from command import TestCase
from page_file import PageFile

ROUNDING = 2.5 # of 255, of a color

if MISSING:
    print(f"skipped: {MISSING} is not installed, so that no browser can be asked")
    sys.exit(77)


def distance(first, second):
    """The largest of the differences of two colors."""
    return max(abs(a - b) for a, b in zip(first, second))


class BrowserTest(TestCase):
    """Tests that share a browser, each with pages of its own."""
    @classmethod
    def setUpClass(cls):
        cls.browser = Browser()
        cls.addClassCleanup(cls.browser.driver.quit)

    def page(self, *arguments, out="a.html"):
        self.succeed(*arguments, "-o", out)
        self.browser.open(self.path(out))
        return PageFile(self.path(out))
