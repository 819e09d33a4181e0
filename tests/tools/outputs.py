# SPDX-License-Identifier: MIT
"""Where commands write is looked at first; what is there already is never lost."""
import hashlib
import json
import os
import pty
import re
import shutil
import signal
import stat
from pathlib import Path

import command
from command import TestCase, golden

SPECTRUM = ("--side", "primal", "--degree", 0, "--count", 2)
# Of every command with a file as output: arguments without it, and the extensions it takes.
WRITERS = {
    "merge": ((), ".off .obj .ply .vtu .html"),
    "spectrum": (SPECTRUM, ".vtu .html"),
    "poisson": (("--side", "primal", "--rhs", "1"), ".vtu .html"),
    "distance": (("--from", 0), ".vtu .html"),
}


class Files(TestCase):
    def arguments(self, name, mesh, out):
        return (name, mesh, *WRITERS[name][0], "-o", out)

    def refuse(self, code, out, words, *arguments):
        """The output cannot be written, by the words of the message, and nothing is."""
        before = sorted(os.listdir(self.folder))
        self.assertSays(self.fail_with(code, *arguments), "polydec: ", "write", f"{out}: ", *words)
        self.assertEqual(sorted(os.listdir(self.folder)), before)

    def test_an_unknown_format_is_refused_before_the_mesh_is_read(self):
        for out in ("a.txt", "a", "a.vtu.gz", "vtu"):
            for name, (_, known) in WRITERS.items():
                self.refuse(2, out, ("extension", f"'{os.path.splitext(out)[1]}'", known),
                            *self.arguments(name, "no-such.off", out))
        self.refuse(2, "a.vtu",
                    ("extension", "'.vtu'", ".off .obj .ply .stl .mesh .nsc .pdm .html"),
                    "generate", "grid", "-o", "a.vtu")

    def test_the_case_of_extensions_does_not_matter(self):
        shutil.copy(golden("uv8.off"), self.path("MESH.OFF"))
        for name in WRITERS:
            self.succeed(*self.arguments(name, "MESH.OFF", f"{name}.VTU"))
            self.assertIn("VTKFile", self.read(f"{name}.VTU")[:100])
            self.succeed(*self.arguments(name, "MESH.OFF", f"{name}.HTML"))
            self.assertIn("<!doctype html>", self.read(f"{name}.HTML")[:100])
        self.succeed("generate", "grid", "-o", "GRID.Nsc")
        self.succeed("info", "GRID.Nsc")
        self.write("tri.NODE", "3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n")
        self.write("tri.ELE", "1 3 0\n0 0 1 2\n")
        for name in ("tri.NODE", "tri.ELE"):
            self.assertEqual(self.ask("info", name)["cells"]["input"], [3, 3, 1])

    def test_an_input_is_never_written_over(self):
        shutil.copy(golden("uv8.off"), self.path("mesh.off"))
        os.symlink("mesh.off", self.path("link.off"))
        os.link(self.path("mesh.off"), self.path("hard.vtu"))
        text = self.read("mesh.off")
        for out in ("mesh.off", "./mesh.off", "link.off", self.path("mesh.off"), "hard.vtu"):
            self.refuse(2, out, ("input", "mesh.off"), "merge", "mesh.off", "-o", out)
        for name in WRITERS:
            self.refuse(2, "hard.vtu", ("input", "mesh.off"),
                        *self.arguments(name, "mesh.off", "hard.vtu"))
        self.assertEqual(self.read("mesh.off"), text)

    def test_nor_is_a_file_that_an_option_names(self):
        """Of numbers, in every option of every command, and whatever the output is."""
        run = ("--until", 1, "--frames", 1)
        picture, series, state = ("-o", "a.vtu"), ("-o", "a.pvd"), ("--checkpoint", "a.checkpoint")
        conditions = ("--essential-where", "--fixed-where")
        boundary = ("--boundary", "--flux", "--exact", "--conductivity")
        for command_of, options, outputs in (
                (("poisson", "--rhs", 1), boundary + conditions, [picture]),
                (("poisson",), ("--rhs",), [picture]),
                (("hodge",), ("--form",), [picture]),
                (("distance",), ("--from-where",), [picture]),
                (("distance", "--from", 0), ("--glue",), [picture]),
                (("spectrum",), conditions, [picture, state]),
                (("heat", "--initial", 1, *run),
                 ("--source", "--boundary-values", "--flux", *conditions), [series, state]),
                (("heat", *run), ("--initial",), [series, state]),
                (("wave", *run), ("--initial",), [series, state]),
                (("flow", *run), ("--vorticity", "--velocity"), [series, state]),
                (("flow", "--vorticity", "x", *run),
                 ("--boundary-velocity", "--no-slip-where", "--open-where", "--rotation"),
                 [series, state]),
                (("maxwell", "--initial", "x;y;z", *run),
                 ("--current", "--permittivity", "--permeability", "--conductivity"),
                 [series, state])):
            for option in options:
                for flag, out in outputs:
                    self.write(out, "1 " * 58)
                    self.refuse(2, out, ("input", f"./{out}"), command_of[0], golden("uv8.off"),
                                *command_of[1:], option, f"./{out}", flag, out)
                    self.assertEqual(self.read(out), "1 " * 58)

    def test_nor_is_one_among_the_steps_of_a_series(self):
        self.succeed("poisson", golden("grid4.nsc"), "--rhs", 1, "-o", "u.vtu")
        os.mkdir(self.path("u"))
        run = ("--initial", "x", "--until", 1, "--frames", 1, "-o", "u.pvd")
        for name in ("u_0007.vtu", "u_12345.vtu"):
            mesh = f"u/{name}"
            shutil.copy(self.path("u.vtu"), self.path(mesh))
            os.symlink(mesh, self.path("link.vtu"))
            text = self.read(mesh)
            for given in (mesh, "link.vtu"):
                self.refuse(2, "u.pvd", (mesh, "input", given), "heat", given, *run)
            self.assertEqual(self.read(mesh), text)
            os.remove(self.path(mesh))
            os.remove(self.path("link.vtu"))
        for name in ("mesh.vtu", "u_.vtu", "u_0.vtu", "u_1x.vtu", "v_0001.vtu"):
            shutil.copy(self.path("u.vtu"), self.path(f"u/{name}"))
            self.succeed("heat", f"u/{name}", *run)
            self.assertIn(name, os.listdir(self.path("u")))

    def test_the_folder_must_be_there(self):
        for name in WRITERS:
            self.refuse(4, "no/a.vtu", ("No such file", "folder no"),
                        *self.arguments(name, "no-such.off", "no/a.vtu"))
        self.write("file", "")
        self.refuse(4, "file/a.off", ("file", "folder"), "merge", "no-such.off", "-o", "file/a.off")

    def test_a_folder_or_pipe_is_no_output(self):
        os.mkdir(self.path("taken.vtu"))
        os.mkfifo(self.path("pipe.vtu"))
        for name in WRITERS:
            for out in ("taken.vtu", "pipe.vtu"):
                self.refuse(4, out, ("folder", "pipe"), *self.arguments(name, "no-such.off", out))

    def test_a_read_only_file_stays(self):
        for name in WRITERS:
            self.write("old.vtu", "precious")
            os.chmod(self.path("old.vtu"), stat.S_IRUSR)
            self.refuse(4, "old.vtu", ("read-only",),
                        *self.arguments(name, "no-such.off", "old.vtu"))
            self.assertEqual(self.read("old.vtu"), "precious")

    def test_a_read_only_folder_takes_nothing(self):
        os.mkdir(self.path("closed"))
        os.chmod(self.path("closed"), stat.S_IRUSR | stat.S_IXUSR)
        for name in WRITERS:
            self.refuse(4, "closed/a.vtu", ("folder closed", "writable"),
                        *self.arguments(name, "no-such.off", "closed/a.vtu"))

    def test_an_empty_name_is_no_name(self):
        for name in WRITERS:
            self.assertSays(self.fail_with(1, *self.arguments(name, golden("uv8.off"), "")),
                            "--out: ", "empty")


class Folders(TestCase):
    def write_operators(self, *options):
        self.succeed("operators", golden("grid4.nsc"), "--out", "out", *options)
        return {name: self.read(f"out/{name}") for name in os.listdir(self.path("out"))}

    def test_a_manifest_tells_what_the_files_are_made_from(self):
        files = self.write_operators("--tolerance", "1e-5")
        manifest = json.loads(files.pop("manifest.json"))
        self.assertEqual(
            list(manifest), ["program", "version", "command", "mesh", "options", "options_sha256",
                             "dimension", "files", "warnings"])
        self.assertEqual((manifest["program"], manifest["command"], manifest["dimension"]),
                         ("polydec", "operators", 2))
        with open(golden("grid4.nsc"), "rb") as file:
            content = file.read()
        self.assertEqual(manifest["mesh"], [{"file": "grid4.nsc", "bytes": len(content),
                                             "sha256": hashlib.sha256(content).hexdigest()}])
        self.assertEqual(manifest["options"], {"merge": True, "tolerance": 1e-5,
                                               "angle_tolerance": None, "delaunay": None,
                                               "keep_groups": False,
                                               "centers": "circumcenters",
                                               "star": "circumcentric"})
        self.assertEqual(manifest["files"], [{"name": name, "bytes": len(text)}
                                             for name, text in sorted(files.items())])
        other = json.loads(self.write_operators()["manifest.json"])
        hashes = {manifest["options_sha256"], other["options_sha256"]}
        for option in ("--star=galerkin", "--weld", "--weld=1e-3", "--join-hanging"):
            told = json.loads(self.write_operators(option)["manifest.json"])
            hashes.add(told["options_sha256"])
        self.assertEqual(len(hashes), 6)
        self.assertEqual(other["mesh"], manifest["mesh"])

    def test_hashes_of_meshes_of_any_length(self):
        for length in (100, 119, 120, 127, 128, 70000): # where blocks of 64 bytes end
            text = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n#"
            content = text.ljust(length, "-").encode()
            with open(self.path("mesh.off"), "wb") as file:
                file.write(content)
            self.succeed("operators", "mesh.off", "--out", f"out{length}")
            manifest = json.loads(self.read(f"out{length}/manifest.json"))
            self.assertEqual(manifest["mesh"][0]["sha256"], hashlib.sha256(content).hexdigest())

    def test_an_earlier_result_is_replaced_as_a_whole(self):
        self.succeed("operators", golden("kuhn3.nsc"), "--out", "out")
        self.assertIn("star_3.mtx", os.listdir(self.path("out")))
        files = self.write_operators()
        self.assertNotIn("star_3.mtx", files)
        self.assertEqual(os.listdir(self.folder), ["out"])

    def test_foreign_files_are_not_lost(self):
        self.write_operators()
        for name in ("notes.txt", "star_9.mtx.orig", "star_9.mtx", "cells_7.txt", "d_0.csv"):
            self.write(f"out/{name}", "mine")
            self.assertSays(self.fail_with(2, "operators", "no-such.off", "--out", "out"), "write",
                            "out: ", f"'{name}'", "earlier result")
            os.remove(self.path(f"out/{name}"))
        os.remove(self.path("out/manifest.json"))
        before = set(os.listdir(self.path("out")))
        self.assertSays(self.fail_with(2, "operators", "no-such.off", "--out", "out"), "write",
                        "out: ", "earlier result")
        self.assertEqual(set(os.listdir(self.path("out"))), before)

    def test_a_foreign_manifest_makes_nothing_ours(self):
        for manifest in ('{"files":[{"name":"star_0.mtx","bytes":4}]}', "", "{", "[]",
                         '{"program":"polydec","warnings":["\\"files\\":[{\\"name\\":'
                         '\\"star_0.mtx\\",\\"bytes\\":4}]"]}',
                         '{"program":"polydec","files":[{"name":"star_0.mtx'):
            os.makedirs(self.path("out"), exist_ok=True)
            self.write("out/manifest.json", manifest)
            self.write("out/star_0.mtx", "mine")
            self.assertSays(self.fail_with(2, "operators", "no-such.off", "--out", "out"), "write",
                            "out: ", "earlier result")

    def test_the_manifest_tells_of_the_mesh_that_was_read(self):
        """Whatever is under its name later on."""
        self.succeed("generate", "grid", "--nx", "100", "--ny", "100", "-o", "mesh.nsc")
        with open(self.path("mesh.nsc"), "rb") as file:
            content = file.read()
        self.write("other.nsc", "other")
        with self.start("operators", "mesh.nsc", "--out", "out") as process:
            command.wait_until(lambda: process.poll() is not None or any(
                name.endswith(".parts") for name in os.listdir(self.folder)),
                "the folder that is written to", pause=0.001)
            os.replace(self.path("other.nsc"), self.path("mesh.nsc"))
            self.assertEqual(process.finish().code, 0)
        told = json.loads(self.read("out/manifest.json"))["mesh"]
        self.assertEqual(told, [{"file": "mesh.nsc", "bytes": len(content),
                                 "sha256": hashlib.sha256(content).hexdigest()}])

    def test_a_mesh_that_changes_while_it_is_read_is_refused(self):
        self.succeed("generate", "grid", "--nx", "200", "--ny", "200", "-o", "mesh.nsc")
        shutil.copy(self.path("mesh.nsc"), self.path("other.nsc"))
        with open(self.path("other.nsc"), "a", encoding="ascii") as file:
            file.write("\n")
        terminal, end = pty.openpty()  # on which the command tells what it does
        with self.start("operators", "mesh.nsc", "--out", "out", stderr=end) as process:
            os.close(end)
            deadline = command.Deadline("the first stage begins")
            told = command.read_piece(terminal, 1000, deadline)
            process.send_signal(signal.SIGSTOP)
            os.replace(self.path("other.nsc"), self.path("mesh.nsc"))
            process.send_signal(signal.SIGCONT)
            told += command.read_all(terminal, "the end of what is told")
            code = process.finish().code
        os.close(terminal)
        self.assertEqual(code, 4, told)
        self.assertIn(b"polydec: mesh.nsc ", told)
        self.assertSays(told.decode(), "mesh.nsc", "changed", "read")
        self.assertEqual(sorted(os.listdir(self.folder)), ["mesh.nsc"])

    def test_an_empty_folder_and_folders_on_the_way_are_fine(self):
        os.mkdir(self.path("empty"))
        for out in ("empty", "a/b/c", "a/b/d/"):
            self.succeed("operators", golden("grid4.nsc"), "--out", out)
            self.assertTrue(os.path.exists(self.path(f"{out}/manifest.json")))

    def test_the_folder_that_one_is_in_stays(self):
        self.assertSays(self.fail_with(2, "operators", golden("grid4.nsc"), "--out", "."), "write",
                        " .: ", "current folder")

    def test_a_link_to_a_folder_stays_a_link(self):
        os.mkdir(self.path("real"))
        os.symlink("real", self.path("out"))
        self.write_operators()
        self.write_operators()
        self.assertTrue(os.path.islink(self.path("out")))
        self.assertTrue(os.path.exists(self.path("real/manifest.json")))

    def test_a_failure_leaves_the_old_result(self):
        before = self.write_operators()
        self.succeed("generate", "grid", "--nx", "60", "--ny", "60", "-o", "big.nsc")
        # files may not grow beyond this size: the same as a full disk
        limit = f"ulimit -f 64; exec {command.COMMAND} operators big.nsc --out out"
        done = command.run_program(["sh", "-c", f"trap '' XFSZ; {limit}"], cwd=self.folder)
        self.assertEqual(done.code, 4, done.err)
        self.assertEqual(sorted(os.listdir(self.folder)), ["big.nsc", "out"])
        self.assertEqual({name: self.read(f"out/{name}") for name in os.listdir(self.path("out"))},
                         before)

    def test_a_file_is_no_folder(self):
        self.write("file", "")
        for name, arguments in (("operators", (golden("grid4.nsc"),)), ("reproduce", ("fig6",))):
            for out in ("file", "file/a/b"):
                self.assertSays(self.fail_with(4, name, *arguments, "--out", out), "create",
                                f"folder {out}: ", f"file {os.path.realpath(self.path('file'))}")

    def test_the_folder_around_one_that_is_replaced_must_be_writable(self):
        os.makedirs(self.path("closed/out"))
        os.chmod(self.path("closed"), stat.S_IRUSR | stat.S_IXUSR)
        closed = os.path.realpath(self.path("closed"))
        self.addCleanup(os.chmod, closed, stat.S_IRWXU)
        for out in ("closed/out", "closed/out/"):
            self.assertSays(self.fail_with(4, "operators", "no-such.off", "--out", out), "write",
                            f"{out}: ", f"folder {closed}", "writable")
        # what is only added to needs no more than itself
        self.succeed("reproduce", "fig6", "--levels", "1", "--out", "closed/out")


class Readme(TestCase):
    """The README shows commands that run, and lists every command."""
    TEXT = (Path(__file__).resolve().parents[2] / "README.md").read_text(encoding="utf-8")

    def test_its_commands_run(self):
        lines = self.TEXT.split("```sh\n")[1].split("```")[0].splitlines()
        for line in lines:
            words = line.split()
            self.assertEqual(words.pop(0), "polydec")
            self.succeed(*words)
            if "-o" in words:
                self.assertIn(words[-1], os.listdir(self.folder))
        self.assertGreaterEqual(len(lines), 5)

    def test_its_table_lists_every_command(self):
        help_text = re.split("(?i)commands:\n", self.succeed("--help").out)[1].split("\n\n")[0]
        listed = re.findall(r"^\| `([a-z-]+)` \|", self.TEXT, re.MULTILINE)
        commands = re.findall(r"^ {1,4}([a-z-]+) ", help_text, re.MULTILINE)
        self.assertGreater(len(commands), 10)
        self.assertEqual(sorted(listed), sorted([*commands, "polydec-mpi"]))
