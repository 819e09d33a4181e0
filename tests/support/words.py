# SPDX-License-Identifier: MIT
"""Asserts messages by their place, numbers and key words instead of whole sentences."""
import re


def pattern(*words):
    """Regular expression of messages that contain these words and numbers, each as a whole, in this
    order."""
    return "(?s)" + ".*?".join(
        (r"(?<![\w.-])" if word[:1].isdigit() else r"(?<!\w)" if word[:1].isalpha() else "")
        + re.escape(word)
        + (r"(?!\w|\.\d)" if word[-1:].isdigit() else r"(?!\w)" if word[-1:].isalpha() else "")
        for word in map(str, words))


def says(message, *words):
    """Whether a message contains these words and numbers, each as a whole, in this order."""
    return re.search(pattern(*words), message) is not None
