# SPDX-License-Identifier: MIT
"""Packages: all places name one version, recipes parse, and CMake accepts their options.

Usage: packaging.py PROGRAM VERSION BUILD [CMAKE COMPILER]. VERSION is CMake's. With CMAKE it also
configures polydec by the options of each recipe, and as a part of another project.
"""
import ast
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import types
import unittest
from pathlib import Path

import sources

ROOT = Path(__file__).resolve().parents[2]
PROGRAM, VERSION, BUILD, *CONFIGURE = sys.argv[1:]
RECIPE = ROOT / "packaging/conda-forge/recipe.yaml"
PORT = ROOT / "packaging/vcpkg"
SPACK = ROOT / "packaging/spack/packages/polydec/package.py"


def run(*words, **variables):
    done = subprocess.run([str(word) for word in words], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, env={**os.environ, **variables})
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, words))}:\n{done.stdout}")
    return done.stdout


def found(pattern, path):
    return re.search(pattern, path.read_text(), re.MULTILINE).group(1)


def read_yaml(text):
    try:
        import yaml
    except ImportError:
        raise unittest.SkipTest("there is no yaml (python3-yaml)") from None
    return yaml.safe_load(text)


def spack_package():
    """The class of the recipe, over stand-ins of what Spack gives it, with all variants on."""
    class CMakePackage:
        @staticmethod
        def define(name, value):
            return f"-D{name}={'ON' if value else 'OFF'}"

        @staticmethod
        def define_from_variant(name, variant):
            return f"-D{name}={'ON' if VARIANTS[variant] else 'OFF'}"

    given = types.ModuleType("spack.package")
    given.CMakePackage = CMakePackage
    for name in ("license", "version", "variant", "depends_on", "extends", "generator"):
        setattr(given, name, lambda *words, **options: None)
    VARIANTS = {}
    given.variant = lambda name, default, description: VARIANTS.update({name: default})
    sys.modules["spack"], sys.modules["spack.package"] = types.ModuleType("spack"), given
    scope = {}
    exec(compile(SPACK.read_text(), str(SPACK), "exec"), scope)  # noqa: S102
    return scope["Polydec"]()


STAND_INS = """
cmake_minimum_required(VERSION 3.25)
function(vcpkg_check_features)
    cmake_parse_arguments(PARSE_ARGV 0 arg "" "OUT_FEATURE_OPTIONS" "FEATURES")
    set(options)
    while(arg_FEATURES)
        list(POP_FRONT arg_FEATURES feature option)
        list(APPEND options -D${option}=ON)
    endwhile()
    set(${arg_OUT_FEATURE_OPTIONS} ${options} PARENT_SCOPE)
endfunction()
function(vcpkg_cmake_configure)
    cmake_parse_arguments(PARSE_ARGV 0 arg "" "SOURCE_PATH" "OPTIONS")
    message("SOURCE_PATH=${arg_SOURCE_PATH}")
    foreach(option IN LISTS arg_OPTIONS)
        message("${option}")
    endforeach()
endfunction()
foreach(name IN ITEMS vcpkg_cmake_install vcpkg_cmake_config_fixup vcpkg_fixup_pkgconfig
        vcpkg_copy_tools vcpkg_install_copyright)
    cmake_language(EVAL CODE "function(${name})\\nendfunction()")
endforeach()
"""


def port_options(cmake, folder):
    """What the portfile configures with, its features on."""
    script = folder / "port.cmake"
    script.write_text(f'{STAND_INS}\nset(FEATURES tools)\nset(CURRENT_PACKAGES_DIR "{folder}/none")\n'
                      f'include("{PORT}/portfile.cmake")\n')
    lines = run(cmake, "-P", script).splitlines()
    if Path(lines[0].removeprefix("SOURCE_PATH=")).resolve() != ROOT:
        raise AssertionError(f"the port builds {lines[0]}")
    return lines[1:]


class OneVersion(unittest.TestCase):
    def test_programs(self):
        self.assertEqual(run(PROGRAM, "--version").strip(), VERSION)
        self.assertEqual(run(sys.executable, "-B", ROOT / "setup.py", "--version").split()[-1], VERSION)
        if (Path(BUILD) / "python/polydec/__init__.py").exists():
            told = run(sys.executable, "-c", "import polydec; print(polydec.__version__)",
                       PYTHONPATH=f"{BUILD}/python")
            self.assertEqual(told.strip(), VERSION)

    def test_packages_of_the_build(self):
        self.assertEqual(found(r"^Version: (.*)$", Path(BUILD) / "polydec.pc"), VERSION)
        self.assertEqual(found(r'^set\(PACKAGE_VERSION "(.*)"\)$',
                               Path(BUILD) / "polydecConfigVersion.cmake"), VERSION)

    def test_descriptions(self):
        self.assertEqual(found(r"^version: (.*)$", ROOT / "CITATION.cff"), VERSION)
        self.assertEqual(json.loads((ROOT / "codemeta.json").read_text())["version"], VERSION)
        self.assertEqual(found(r'^  version: "(.*)"$', RECIPE), VERSION)
        self.assertEqual(json.loads((PORT / "vcpkg.json").read_text())["version"], VERSION)
        self.assertEqual(found(r'^    version\("([^"]*)"', SPACK), VERSION)
        self.assertEqual(found(r"\Apolydec \(([^-)]*)", ROOT / "debian/changelog"), VERSION)


class Sources(unittest.TestCase):
    def test_they_use_no_name_that_eigen_3_and_5_do_not_share(self):
        for path in filter(sources.is_cpp, sources.files(ROOT)):
            with self.subTest(path):
                self.assertNotRegex(sources.text(ROOT, path), r"\bEigen::(all|last|lastp1|lastN)\b")


class Recipes(unittest.TestCase):
    def test_they_parse(self):
        self.assertEqual(read_yaml((ROOT / "CITATION.cff").read_text())["title"], "polydec")
        recipe = read_yaml(RECIPE.read_text())
        self.assertEqual(recipe["package"]["name"], "polydec")
        self.assertIn("eigen >=3.4,<6", recipe["requirements"]["host"])
        ast.parse(SPACK.read_text())
        self.assertEqual(read_yaml((ROOT / "paper/paper.md").read_text().split("---")[1])["bibliography"], "paper.bib")

    @unittest.skipUnless(shutil.which("appstreamcli"), "there is no appstreamcli (appstream)")
    def test_software_centers_read_the_description(self):
        run("appstreamcli", "validate", "--no-net", ROOT / "cmake/polydec.metainfo.xml")

    def test_the_paper_cites_what_there_is(self):
        cited = set(re.findall(r"@([a-z]+[0-9]*)", (ROOT / "paper/paper.md").read_text()))
        known = set(re.findall(r"^@\w+\{(\w+),", (ROOT / "paper/paper.bib").read_text(), re.M))
        self.assertEqual(cited, known)


CONTAINING = f"""cmake_minimum_required(VERSION 3.25)
project(containing LANGUAGES CXX)
add_subdirectory({ROOT} polydec)
file(WRITE program.cpp "#include <polydec.h>\\nint main() {{}}")
add_executable(program program.cpp)
target_link_libraries(program PRIVATE polydec::polydec)
"""


@unittest.skipUnless(CONFIGURE, "not asked for")
class Configured(unittest.TestCase):
    def configure(self, source, *options):
        cmake, compiler = CONFIGURE
        with tempfile.TemporaryDirectory() as folder:
            run(cmake, "-S", source, "-B", folder, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={compiler}",
                *options)
            steps = (Path(folder) / "build.ninja").read_text()
        return set(re.findall(r"^build (\S+\.(?:o|a|so)\b|\w+)(?=:| )", steps, re.M))

    def test_by_the_options_of_conda(self):
        script = " ".join(read_yaml(RECIPE.read_text())["build"]["script"])
        options = [word for word in script.split() if word.startswith("-D")]
        options = [word.replace("${PYTHON}", sys.executable) for word in options]
        self.assertIn("polydec_command", self.configure(ROOT, *options))

    def test_by_the_options_of_debian(self):
        options = re.findall(r"-D\S+", (ROOT / "debian/rules").read_text())
        steps = self.configure(ROOT, *options)
        for package in ("cholmod", "cvode", "mumps", "petsc", "slepc"):
            self.assertIn(f"lib/polydec/{package}.so", steps)
        self.assertNotIn("polydec_cholmod", steps)

    def test_by_the_options_of_vcpkg(self):
        with tempfile.TemporaryDirectory() as folder:
            options = port_options(CONFIGURE[0], Path(folder))
        self.assertIn("-DPOLYDEC_COMMAND=ON", options)
        self.assertIn("polydec_command", self.configure(ROOT, *options))

    def test_by_the_options_of_spack(self):
        self.assertIn("polydec_command", self.configure(ROOT, *spack_package().cmake_args()))

    def test_as_a_part_of_another_project(self):
        """With four packages alone: Eigen, Spectra, fmt and zlib."""
        absent = ("CLI11", "muparser", "pybind11", "Python", "benchmark", "CHOLMOD", "SUNDIALS",
                  "MUMPS", "PETSc", "SLEPc")
        with tempfile.TemporaryDirectory() as source:
            (Path(source) / "CMakeLists.txt").write_text(CONTAINING)
            steps = self.configure(source, "-DRAPIDJSON_INCLUDE_DIR=",
                                   *(f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in absent))
        objects = {step for step in steps if step.endswith(".o")}
        library = {name for name in objects if name.startswith("polydec/CMakeFiles/polydec.dir/")}
        others = {name for name in objects - library
                  if "polydec_page_template" not in name and "/examples/plots/" not in name}
        self.assertGreater(len(library), 200)
        self.assertEqual(others, {"CMakeFiles/program.dir/program.cpp.o"})


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
