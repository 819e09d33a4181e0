#!/bin/sh
# SPDX-License-Identifier: MIT
# Writes polydec-VERSION.tar.gz of a commit (default: HEAD) to a folder (default: here). The same commit
# gives the same bytes: git takes times from the commit, and gzip stores no name and no time.
# Usage: scripts/tarball.sh [FOLDER [COMMIT]]
set -eu
folder=$(cd "${1:-.}" && pwd)
commit=${2:-HEAD}
cd "$(dirname "$0")/.."
version=$(git show "$commit:CMakeLists.txt" | sed -n 's/^project(polydec VERSION \([0-9.]*\).*/\1/p')
name=polydec-$version
git -c tar.umask=0022 archive --format=tar --prefix="$name/" "$commit" | gzip -9n >"$folder/$name.tar.gz"
echo "$folder/$name.tar.gz"
