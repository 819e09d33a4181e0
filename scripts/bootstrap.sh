# SPDX-License-Identifier: MIT
# shellcheck shell=sh disable=SC2086 # names of packages are split into words on purpose
# Sourced by ./demo and ./test in the root of the checkout: the packages, and building a preset.

say() { printf '%s\n' "$*"; }
complain() { printf '%s\n' "$*" >&2; }
fail() {
    code=$1
    shift
    complain "$@"
    exit "$code"
}

# listed_packages SET: the names after the line `# SET:` of packages.txt.
listed_packages() {
    awk -v wanted="$1:" '/^#/ { inside = $2 == wanted; next } inside && NF' packages.txt
}

# Of the names on stdin, those that are not installed.
missing_packages() {
    while read -r name; do
        dpkg-query -W -f='${db:Status-Status}\n' "$name" 2>/dev/null | grep -qx installed ||
            say "$name"
    done
}

# Runs a command as root; sudo asks for a password at a terminal only.
as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    elif ! command -v sudo >/dev/null 2>&1; then
        complain "Not root, and there is no sudo."
        return 1
    elif [ -t 0 ]; then
        sudo "$@"
    else
        sudo -n "$@"
    fi
}

apt_get() {
    as_root env DEBIAN_FRONTEND=noninteractive apt-get -q \
        -o Acquire::Retries=1 -o Acquire::http::Timeout=20 -o Acquire::https::Timeout=20 \
        -o DPkg::Lock::Timeout=120 "$@"
}

# The package lists may be absent or too old: they are fetched where a first try fails, once.
apt_install() {
    apt_get install -y --no-install-recommends "$@" && return 0
    [ -z "$lists_fetched" ] || return 1
    lists_fetched=yes
    say "That failed; once more with fresh package lists."
    apt_get update && apt_get install -y --no-install-recommends "$@"
}
lists_fetched=

# install_packages SET ..: installs missing packages of the set `required` and of these sets. Exits with
# code 4 if a required package cannot be installed.
install_packages() {
    if [ "${POLYDEC_PACKAGES:-}" = skip ]; then
        say "POLYDEC_PACKAGES=skip: trusting that what packages.txt lists is there."
        return 0
    fi
    if ! command -v dpkg-query >/dev/null 2>&1; then
        say "Notice: no dpkg here; packages.txt lists, by Debian's names, what must be there."
        return 0
    fi

    for set in required "$@"; do
        missing=$(listed_packages "$set" | missing_packages)
        [ -n "$missing" ] || continue
        say "Installing ($set):" $missing
        say_what_it_takes $missing
        apt_install $missing || for name in $missing; do
            apt_install "$name" || say "Notice: going on without $name."
        done
    done
    missing=$(listed_packages required | missing_packages)
    [ -z "$missing" ] || fail 4 \
        "These packages are needed and could not be installed:" $missing "
Install them by hand, or set POLYDEC_PACKAGES=skip if you have them from elsewhere."
}

# say_what_it_takes PACKAGE ..: the size of the download and on disk, as apt-get estimates it.
say_what_it_takes() {
    apt-get --assume-no --no-install-recommends -o Debug::NoLocking=1 install "$@" 2>/dev/null |
        grep -E '^(Need to get|After this)' || true
}

# How many compilers at once: POLYDEC_JOBS, or the number of processors but at most 2, since a
# compiler of template code wants 1 GB of memory.
count_jobs() {
    case ${POLYDEC_JOBS:-} in
        '') processors=$(nproc 2>/dev/null || echo 2)
            [ "$processors" -lt 2 ] && echo 1 || echo 2 ;;
        *[!0-9]* | 0*)
            fail 1 "POLYDEC_JOBS must be a positive whole number, not '$POLYDEC_JOBS'."
            ;;
        *) echo "$POLYDEC_JOBS" ;;
    esac
}
jobs=$(count_jobs) || exit 1

# configure PRESET [-DNAME=VALUE ..]; a build folder that came along with a moved checkout is begun anew.
configure() {
    preset=$1
    shift
    # The active Python, unless it lacks numpy and Debian's has it.
    if ! python3 -c 'import numpy' 2>/dev/null && /usr/bin/python3 -c 'import numpy' 2>/dev/null; then
        set -- -DPython_EXECUTABLE=/usr/bin/python3 "$@"
    fi
    home="CMAKE_HOME_DIRECTORY:INTERNAL=$(pwd -P)"
    if [ -f "build/$preset/CMakeCache.txt" ] && ! grep -qxF "$home" "build/$preset/CMakeCache.txt"; then
        cmake --fresh --preset "$preset" "$@"
    else
        cmake --preset "$preset" "$@"
    fi
}

# build PRESET [--target NAME ..]
build() {
    preset=$1
    shift
    cmake --build --preset "$preset" -j "$jobs" "$@"
}

# build_if_known PRESET TARGET ..: builds those targets that this configuration has.
build_if_known() {
    preset=$1
    shift
    known=$(ninja -C "build/$preset" -t targets all)
    for target; do
        shift
        case $known in *"$target: phony"*) set -- "$@" "$target" ;; esac
    done
    build "$preset" --target "$@"
}
