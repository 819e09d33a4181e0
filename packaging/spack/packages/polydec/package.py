# SPDX-License-Identifier: MIT
# A release adds url and a version with the sha256 of the tarball.
from spack.package import *


class Polydec(CMakePackage):
    """Discrete exterior calculus on the mesh you have, in any dimension: a C++20 library, a Python
    package and a command."""

    license("MIT")

    version("0.1.0")

    variant("shared", default=True, description="Build a shared library")
    variant("tools", default=True, description="Build the command polydec")
    variant("python", default=False, description="Build the package for Python")
    variant("openmp", default=True, description="Use several threads, by OpenMP")
    variant("cholmod", default=True, description="Build the engine CHOLMOD")
    variant("mumps", default=False, description="Build the engine MUMPS")
    variant("petsc", default=False, description="Build the engines of PETSc and SLEPc")
    variant("cvode", default=False, description="Build the integrator CVODE")

    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("eigen@3.4:5")
    depends_on("fmt")
    depends_on("spectra", type="build")
    depends_on("zlib-api")
    depends_on("cli11", type="build", when="+tools")
    depends_on("rapidjson", type="build", when="+tools")
    depends_on("rapidjson", type="build", when="+python")
    depends_on("muparser", when="+tools")
    depends_on("suite-sparse", when="+cholmod")
    depends_on("mumps~mpi", when="+mumps")
    depends_on("petsc", when="+petsc")
    depends_on("slepc", when="+petsc")
    depends_on("sundials", when="+cvode")
    depends_on("python@3.9:", type=("build", "run"))
    depends_on("py-pybind11@2.10:", type="build", when="+python")
    depends_on("py-numpy", type=("build", "run"), when="+python")
    depends_on("py-scipy", type=("build", "run"), when="+python")
    extends("python", when="+python")

    generator("ninja")

    def cmake_args(self):
        return [
            self.define_from_variant("BUILD_SHARED_LIBS", "shared"),
            self.define_from_variant("POLYDEC_COMMAND", "tools"),
            self.define_from_variant("POLYDEC_PYTHON", "python"),
            self.define_from_variant("POLYDEC_OPENMP", "openmp"),
            self.define_from_variant("POLYDEC_CHOLMOD", "cholmod"),
            self.define_from_variant("POLYDEC_MUMPS", "mumps"),
            self.define_from_variant("POLYDEC_PETSC", "petsc"),
            self.define_from_variant("POLYDEC_SLEPC", "petsc"),
            self.define_from_variant("POLYDEC_CVODE", "cvode"),
            self.define("POLYDEC_EXAMPLES", False),
            self.define("POLYDEC_BENCHMARKS", False),
            self.define("POLYDEC_DISTRIBUTED", False),
        ]
