#!/bin/sh
# SPDX-License-Identifier: MIT
# Builds the site of the documentation from clean: pages, C++ and Python in one search.
# Usage: scripts/site.sh [FOLDER] (default: build/site). Needs Sphinx, myst-parser, the theme of
# Read the Docs, MathJax 2, doxygen, nbclient, IPython's kernel and matplotlib (packages.txt), and the
# package polydec, on PYTHONPATH or in build/release/python. PYTHON names another interpreter.
# POLYDEC_EDIT_ADDRESS, the address of a forge's editor, adds links to edit.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
folder=${1:-$root/build/site}
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
rm -rf "$folder/source" "$folder/static" "$folder/doxygen" "$folder/doctrees" "$folder/html"
python=${PYTHON:-/usr/bin/python3}
export PYTHONPATH="${PYTHONPATH:-$root/build/release/python}" PYTHONDONTWRITEBYTECODE=1
export POLYDEC_SOURCES="$root" POLYDEC_SITE="$folder" OMP_NUM_THREADS=1
"$python" "$root/docs/site/pages.py" "$folder/source"
"$python" -m sphinx -q -W --keep-going -c "$root/docs/site" -d "$folder/doctrees" -E \
    "$folder/source" "$folder/html"
echo "$folder/html/index.html"
