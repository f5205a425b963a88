# What the library links. Also read by the installed bezcertConfig.cmake, so that consumers find the same.
find_package(Boost 1.74 REQUIRED)

find_library(BEZCERT_GMP_LIBRARY gmp REQUIRED)
find_library(BEZCERT_MPFR_LIBRARY mpfr REQUIRED)
# SHA-256 (lib/bezcert/io/file).
find_library(BEZCERT_NETTLE_LIBRARY nettle REQUIRED)
# Factors, resultants, common divisors (lib/bezcert/algebra).
find_library(BEZCERT_FLINT_LIBRARY flint REQUIRED)
find_path(BEZCERT_GMP_INCLUDE_DIR gmp.h REQUIRED)
find_path(BEZCERT_MPFR_INCLUDE_DIR mpfr.h REQUIRED)
# CGAL's interval arithmetic is header-only; its CMake package would bring compile flags along that we set ourselves.
find_path(BEZCERT_CGAL_INCLUDE_DIR CGAL/Interval_nt.h REQUIRED)
