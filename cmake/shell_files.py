# SPDX-License-Identifier: MIT
"""Makes manual pages, and completions for bash, zsh and fish, of what the command says of itself.

Usage: shell_files.py PROGRAM VERSION FOLDER. Below FOLDER it writes man/man1/polydec.1 and a page for
each command, bash-completion/completions/polydec, zsh/site-functions/_polydec and
fish/vendor_completions.d/polydec.fish. The commands and options are those of `PROGRAM --describe`
(tools/describe.h); a manual page shows what --help prints.
"""
import os
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path

NAME = "polydec"


@dataclass
class Option:
    names: list
    takes_value: bool
    text: str


@dataclass
class Command:
    text: str = ""
    options: list = field(default_factory=list)
    commands: list = field(default_factory=list)  # words that may follow


def ask(program, *words):
    environment = {**os.environ, "COLUMNS": "80", "LC_ALL": "C.UTF-8"}
    return subprocess.run([program, *words], check=True, text=True, stdout=subprocess.PIPE,
                          encoding="utf-8", env=environment).stdout


def commands_of(program):
    """The commands by their words with blanks between them; "" is the program."""
    commands = {"": Command()}
    for line in ask(program, "--describe").splitlines():
        kind, path, *rest = line.split("\t")
        if kind == "command":
            commands[path] = Command(rest[0])
            before, _, word = path.rpartition(" ")
            commands[before].commands.append(word)
        else:
            names, takes_value, text = rest
            commands[path].options.append(Option(names.split(), takes_value == "1", text))
    return commands


def roff(text):
    """Text as it is, for man."""
    escaped = text.replace("\\", "\\e").replace("-", "\\-").replace("'", "\\(aq")
    return "\n".join("\\&" + line if line.startswith(".") else line
                     for line in escaped.splitlines())


def manual_page(program, path, commands, version):
    name = "-".join([NAME, *path.split()])
    title = commands[path].text or "discrete exterior calculus on the mesh you have"
    parts = [f'.TH {name.upper()} 1 "" "{NAME} {version}" "User Commands"',
             ".SH NAME", f"{roff(name)} \\- {roff(title)}",
             ".SH SYNOPSIS", f".B {roff(' '.join([NAME, path]).strip())}", ".I ...",
             ".SH DESCRIPTION"]
    below = [other for other in commands if path and other.startswith(path + " ")]
    for shown in [path, *below]:
        parts += [".SS " + roff(f"{NAME} {shown}")] if below else []
        parts += [".EX", roff(ask(program, *shown.split(), "--help").strip()), ".EE"]
    if not path:
        pages = [f".BR {roff(NAME + '-' + word)} (1)" for word in commands[path].commands]
        parts += [".SH SEE ALSO", ",\n".join(pages)]
    else:
        parts += [".SH SEE ALSO", f".BR {NAME} (1)"]
    return "\n".join(parts) + "\n"


def quoted(text):
    """A word for a shell."""
    return "'" + text.replace("'", "'\\''") + "'"


def bash(commands):
    cases = "".join(
        f"        {quoted(path)}) echo {quoted(' '.join(words_of(command)))} ;;\n"
        for path, command in commands.items())
    values = sorted({name for command in commands.values() for option in command.options
                     if option.takes_value for name in option.names})
    return f"""# bash completion of {NAME}; made by cmake/shell_files.py
_{NAME}_words() {{
    case $1 in
{cases}    esac
}}

_{NAME}() {{
    local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}} place= word
    for word in "${{COMP_WORDS[@]:1:COMP_CWORD - 1}}"; do
        case $word in
            -*) ;;
            *) case " $(_{NAME}_words "$place") " in *" $word "*) place=${{place:+$place }}$word ;; esac ;;
        esac
    done
    COMPREPLY=()
    case " {' '.join(values)} " in
        *" $previous "*) ;; # a value: files, by -o default
        *) mapfile -t COMPREPLY < <(compgen -W "$(_{NAME}_words "$place")" -- "$current") ;;
    esac
}}
complete -o default -F _{NAME} {NAME}
"""


def words_of(command):
    return command.commands + [name for option in command.options for name in option.names]


def zsh(commands):
    def described(word, text):
        return quoted(word.replace(":", "\\:") + ":" + text)

    cases = ""
    for path, command in commands.items():
        known = [described(word, commands[f"{path} {word}".strip()].text)
                 for word in command.commands]
        known += [described(name, option.text) for option in command.options
                  for name in option.names]
        cases += f"        ({quoted(path)}) known=({' '.join(known)}) ;;\n"
    return f"""#compdef {NAME}
# zsh completion of {NAME}; made by cmake/shell_files.py
local place= word
local -a known
_{NAME}_known() {{
    case $1 in
{cases}        (*) known=() ;;
    esac
}}
for word in ${{words[2,CURRENT-1]}}; do
    _{NAME}_known "$place"
    if [[ $word != -* && -n ${{(M)known:#$word:*}} ]]; then
        place=${{place:+$place }}$word
    fi
done
_{NAME}_known "$place"
_describe -o {NAME} known
_files
"""


def fish(commands):
    lines = [f"# fish completion of {NAME}; made by cmake/shell_files.py"]
    for path, command in commands.items():
        words = path.split()
        condition = " ; and ".join(f"__fish_seen_subcommand_from {word}" for word in words)
        first = "__fish_use_subcommand" if not words else condition
        if words and command.commands:
            first += " ; and not __fish_seen_subcommand_from " + " ".join(command.commands)
        for word in command.commands:
            text = commands[f"{path} {word}".strip()].text
            lines.append(f"complete -c {NAME} -n {quoted(first)} -a {quoted(word)} "
                         f"-d {quoted(text)}")
        for option in command.options:
            names = " ".join(f"-l {name[2:]}" if name.startswith("--") else f"-s {name[1:]}"
                             for name in option.names)
            lines.append(f"complete -c {NAME} -n {quoted(first if not words else condition)} "
                         f"{names}{' -r' if option.takes_value else ''} -d {quoted(option.text)}")
    return "\n".join(lines) + "\n"


def write(file, text):
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8")


def main(program, version, folder):
    commands = commands_of(program)
    for path in commands:
        if " " not in path:
            name = "-".join([NAME, *path.split()])
            write(folder / f"man/man1/{name}.1", manual_page(program, path, commands, version))
    write(folder / f"bash-completion/completions/{NAME}", bash(commands))
    write(folder / f"zsh/site-functions/_{NAME}", zsh(commands))
    write(folder / f"fish/vendor_completions.d/{NAME}.fish", fish(commands))


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2], Path(sys.argv[3]))
