# Recipe of Spack. It is parsed by a test and was not tested with Spack. There is no archive to download yet:
# `spack dev-build bempd@0.3.0` builds the source tree at hand.
from spack.package import *


class Bempd(CMakePackage):
    """Cracks in two-dimensional elastic bodies: boundary elements coupled with peridynamics."""

    version("0.3.0")

    license("MIT")  # the library alone; a build with SuiteSparse is distributed under GPL-2.0-or-later

    variant("linalg", default="suitesparse", values=("suitesparse", "eigen"), multi=False,
            description="Sparse factorization: suitesparse (fast; its CHOLMOD modules are GPL) or eigen (permissive)")
    variant("paper", default=True, description="Build the scheme paper, which is there to compare with")
    variant("fortran", default=True, description="Build the Fortran module")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("fortran", type="build", when="+fortran")
    depends_on("cmake@3.22:", type="build")
    depends_on("pkgconfig", type="build")
    depends_on("eigen@3.4:3", type="build")
    depends_on("blas")
    depends_on("lapack")
    depends_on("suite-sparse@5.12:", when="linalg=suitesparse")

    conflicts("platform=darwin", msg="no build on macOS was tested; docs/linking.md has steps from source")
    conflicts("platform=windows", msg="bempd does not build on Windows")
    conflicts("%gcc@:11", msg="bempd is tested with GCC 12")

    def cmake_args(self):
        return [
            self.define_from_variant("BEMPD_LINALG", "linalg"),
            self.define_from_variant("BEMPD_SCHEME_PAPER", "paper"),
            self.define_from_variant("BEMPD_BUILD_FORTRAN", "fortran"),
            self.define("BEMPD_BUILD_TESTS", False),
            self.define("BEMPD_BUILD_EXAMPLES", False),
            self.define("BEMPD_BUILD_BENCHMARKS", False),
            self.define("BEMPD_INSTALL", True),
        ]
