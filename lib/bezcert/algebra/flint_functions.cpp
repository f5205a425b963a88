// FLINT's functions that this folder calls, each found when it is first called.
//
// Few elements need algebra, but a program that is linked with FLINT loads it, and NTL with it, at every
// start: a third of the time that starting `certify` took (docs/performance.md). So the library is not
// linked. These definitions take the place of FLINT's and pass their arguments on; the compiler compares them
// with FLINT's own declarations. A function that is missing here is an undefined reference for the linker:
// add it.
#include "bezcert/algebra/flint_functions.hpp"

#include <dlfcn.h>
#include <flint/fmpq.h>
#include <flint/fmpq_poly.h>
#include <flint/fmpz_mpoly.h>
#include <flint/fmpz_mpoly_factor.h>
#include <flint/fmpz_poly_factor.h>
#include <flint/fmpz_vec.h>
#include <flint/nmod_poly.h>
#include <flint/ulong_extras.h>

#include <string>

namespace {

struct Library {
  void* handle = nullptr;
  std::string why;

  Library() {
    // Where the loader looks, or where it was when this was compiled.
    for (const char* name : {BEZCERT_FLINT, BEZCERT_FLINT_PATH}) {
      handle = ::dlopen(name, RTLD_NOW | RTLD_LOCAL);
      if (handle != nullptr) return;
      const char* const error = ::dlerror();
      if (why.empty() && error != nullptr) why = error;
    }
  }
};

void* find(const char* name) {
  static const Library library;
  void* const found = library.handle != nullptr ? ::dlsym(library.handle, name) : nullptr;
  if (found != nullptr) return found;
  throw bezcert::FlintMissing(
      std::string("FLINT cannot be loaded, expected ") + BEZCERT_FLINT + ": " +
      (library.handle != nullptr ? std::string(name) + " is not in it" : library.why));
}

}  // namespace

#define FORWARD(result, name, parameters, arguments)                           \
  result name parameters {                                                     \
    static const auto real = reinterpret_cast<decltype(&::name)>(find(#name)); \
    return real arguments;                                                     \
  }

extern "C" {
FORWARD(void, _fmpq_poly_set_length, (fmpq_poly_t poly, slong len), (poly, len))
FORWARD(void, _fmpz_clear_mpz, (fmpz f), (f))
FORWARD(__mpz_struct*, _fmpz_promote, (fmpz_t f), (f))
FORWARD(void, _fmpz_vec_clear, (fmpz * vec, slong len), (vec, len))
FORWARD(void, _fmpz_vec_content, (fmpz_t res, const fmpz* vec, slong len), (res, vec, len))
FORWARD(fmpz*, _fmpz_vec_init, (slong len), (len))
FORWARD(void, fmpq_poly_add, (fmpq_poly_t res, const fmpq_poly_t poly1, const fmpq_poly_t poly2),
        (res, poly1, poly2))
FORWARD(void, fmpq_poly_clear, (fmpq_poly_t poly), (poly))
FORWARD(void, fmpq_poly_fit_length, (fmpq_poly_t poly, slong len), (poly, len))
FORWARD(void, fmpq_poly_get_coeff_fmpq, (fmpq_t x, const fmpq_poly_t poly, slong n), (x, poly, n))
FORWARD(void, fmpq_poly_init, (fmpq_poly_t poly), (poly))
FORWARD(void, fmpq_poly_mul, (fmpq_poly_t res, const fmpq_poly_t poly1, const fmpq_poly_t poly2),
        (res, poly1, poly2))
FORWARD(void, fmpq_poly_neg, (fmpq_poly_t poly1, const fmpq_poly_t poly2), (poly1, poly2))
FORWARD(void, fmpq_poly_rem, (fmpq_poly_t R, const fmpq_poly_t poly1, const fmpq_poly_t poly2),
        (R, poly1, poly2))
FORWARD(void, fmpq_poly_scalar_div_fmpz, (fmpq_poly_t rop, const fmpq_poly_t op, const fmpz_t c),
        (rop, op, c))
FORWARD(void, fmpq_poly_scalar_mul_fmpz, (fmpq_poly_t rop, const fmpq_poly_t op, const fmpz_t c),
        (rop, op, c))
FORWARD(void, fmpq_poly_scalar_mul_ui, (fmpq_poly_t rop, const fmpq_poly_t op, ulong c), (rop, op, c))
FORWARD(void, fmpq_poly_set, (fmpq_poly_t poly1, const fmpq_poly_t poly2), (poly1, poly2))
FORWARD(void, fmpq_poly_set_coeff_fmpq, (fmpq_poly_t poly, slong n, const fmpq_t x), (poly, n, x))
FORWARD(void, fmpq_poly_set_coeff_mpq, (fmpq_poly_t poly, slong n, const mpq_t x), (poly, n, x))
FORWARD(void, fmpq_poly_set_fmpz_poly, (fmpq_poly_t rop, const fmpz_poly_t op), (rop, op))
FORWARD(void, fmpq_poly_sub, (fmpq_poly_t res, const fmpq_poly_t poly1, const fmpq_poly_t poly2),
        (res, poly1, poly2))
FORWARD(void, fmpq_poly_xgcd,
        (fmpq_poly_t G, fmpq_poly_t S, fmpq_poly_t T, const fmpq_poly_t A, const fmpq_poly_t B),
        (G, S, T, A, B))
FORWARD(int, fmpq_reconstruct_fmpz, (fmpq_t res, const fmpz_t a, const fmpz_t m), (res, a, m))
FORWARD(void, fmpz_get_mpz, (mpz_t x, const fmpz_t f), (x, f))
FORWARD(slong, fmpz_get_si, (const fmpz_t f), (f))
FORWARD(void, fmpz_mod, (fmpz_t f, const fmpz_t g, const fmpz_t h), (f, g, h))
FORWARD(void, fmpz_mpoly_clear, (fmpz_mpoly_t A, const fmpz_mpoly_ctx_t ctx), (A, ctx))
FORWARD(void, fmpz_mpoly_ctx_clear, (fmpz_mpoly_ctx_t ctx), (ctx))
FORWARD(void, fmpz_mpoly_ctx_init, (fmpz_mpoly_ctx_t ctx, slong nvars, const ordering_t ord),
        (ctx, nvars, ord))
FORWARD(int, fmpz_mpoly_divides,
        (fmpz_mpoly_t Q, const fmpz_mpoly_t A, const fmpz_mpoly_t B, const fmpz_mpoly_ctx_t ctx),
        (Q, A, B, ctx))
FORWARD(int, fmpz_mpoly_factor, (fmpz_mpoly_factor_t f, const fmpz_mpoly_t A, const fmpz_mpoly_ctx_t ctx),
        (f, A, ctx))
FORWARD(void, fmpz_mpoly_factor_clear, (fmpz_mpoly_factor_t f, const fmpz_mpoly_ctx_t ctx), (f, ctx))
FORWARD(int, fmpz_mpoly_gcd,
        (fmpz_mpoly_t G, const fmpz_mpoly_t A, const fmpz_mpoly_t B, const fmpz_mpoly_ctx_t ctx),
        (G, A, B, ctx))
FORWARD(void, fmpz_mpoly_get_term_coeff_fmpz,
        (fmpz_t c, const fmpz_mpoly_t A, slong i, const fmpz_mpoly_ctx_t ctx), (c, A, i, ctx))
FORWARD(void, fmpz_mpoly_get_term_exp_ui,
        (ulong * exp, const fmpz_mpoly_t A, slong i, const fmpz_mpoly_ctx_t ctx), (exp, A, i, ctx))
FORWARD(void, fmpz_mpoly_init, (fmpz_mpoly_t A, const fmpz_mpoly_ctx_t ctx), (A, ctx))
FORWARD(void, fmpz_mpoly_scalar_divexact_fmpz,
        (fmpz_mpoly_t A, const fmpz_mpoly_t B, const fmpz_t c, const fmpz_mpoly_ctx_t ctx), (A, B, c, ctx))
FORWARD(void, fmpz_mpoly_set, (fmpz_mpoly_t A, const fmpz_mpoly_t B, const fmpz_mpoly_ctx_t ctx), (A, B, ctx))
FORWARD(void, fmpz_mpoly_set_coeff_fmpz_ui,
        (fmpz_mpoly_t A, const fmpz_t c, const ulong* exp, const fmpz_mpoly_ctx_t ctx), (A, c, exp, ctx))
FORWARD(void, fmpz_mul_ui, (fmpz_t f, const fmpz_t g, ulong x), (f, g, x))
FORWARD(void, fmpz_poly_CRT_ui,
        (fmpz_poly_t res, const fmpz_poly_t poly1, const fmpz_t m1, const nmod_poly_t poly2, int sign),
        (res, poly1, m1, poly2, sign))
FORWARD(void, fmpz_poly_clear, (fmpz_poly_t poly), (poly))
FORWARD(void, fmpz_poly_derivative, (fmpz_poly_t res, const fmpz_poly_t poly), (res, poly))
FORWARD(void, fmpz_poly_div, (fmpz_poly_t Q, const fmpz_poly_t A, const fmpz_poly_t B), (Q, A, B))
FORWARD(int, fmpz_poly_divides, (fmpz_poly_t q, const fmpz_poly_t a, const fmpz_poly_t b), (q, a, b))
FORWARD(void, fmpz_poly_factor, (fmpz_poly_factor_t fac, const fmpz_poly_t G), (fac, G))
FORWARD(void, fmpz_poly_factor_clear, (fmpz_poly_factor_t fac), (fac))
FORWARD(void, fmpz_poly_factor_init, (fmpz_poly_factor_t fac), (fac))
FORWARD(void, fmpz_poly_gcd, (fmpz_poly_t res, const fmpz_poly_t poly1, const fmpz_poly_t poly2),
        (res, poly1, poly2))
FORWARD(void, fmpz_poly_get_coeff_fmpz, (fmpz_t x, const fmpz_poly_t poly, slong n), (x, poly, n))
FORWARD(void, fmpz_poly_get_nmod_poly, (nmod_poly_t res, const fmpz_poly_t poly), (res, poly))
FORWARD(void, fmpz_poly_init, (fmpz_poly_t poly), (poly))
FORWARD(void, fmpz_poly_interpolate_fmpz_vec, (fmpz_poly_t poly, const fmpz* xs, const fmpz* ys, slong n),
        (poly, xs, ys, n))
FORWARD(void, fmpz_poly_mul, (fmpz_poly_t res, const fmpz_poly_t poly1, const fmpz_poly_t poly2),
        (res, poly1, poly2))
FORWARD(void, fmpz_poly_primitive_part, (fmpz_poly_t res, const fmpz_poly_t poly), (res, poly))
FORWARD(void, fmpz_poly_resultant, (fmpz_t res, const fmpz_poly_t poly1, const fmpz_poly_t poly2),
        (res, poly1, poly2))
FORWARD(void, fmpz_poly_set_coeff_fmpz, (fmpz_poly_t poly, slong n, const fmpz_t x), (poly, n, x))
FORWARD(void, fmpz_set_mpz, (fmpz_t f, const mpz_t x), (f, x))
FORWARD(ulong, n_nextprime, (ulong n, int proved), (n, proved))
FORWARD(void, nmod_poly_clear, (nmod_poly_t poly), (poly))
FORWARD(void, nmod_poly_derivative, (nmod_poly_t x_prime, const nmod_poly_t x), (x_prime, x))
FORWARD(void, nmod_poly_fit_length, (nmod_poly_t poly, slong alloc), (poly, alloc))
FORWARD(void, nmod_poly_gcd, (nmod_poly_t G, const nmod_poly_t A, const nmod_poly_t B), (G, A, B))
FORWARD(void, nmod_poly_init, (nmod_poly_t poly, ulong n), (poly, n))
FORWARD(int, nmod_poly_invmod, (nmod_poly_t A, const nmod_poly_t B, const nmod_poly_t P), (A, B, P))
FORWARD(void, nmod_poly_mulmod,
        (nmod_poly_t res, const nmod_poly_t poly1, const nmod_poly_t poly2, const nmod_poly_t f),
        (res, poly1, poly2, f))
FORWARD(void, nmod_poly_rem, (nmod_poly_t R, const nmod_poly_t A, const nmod_poly_t B), (R, A, B))
FORWARD(void, nmod_poly_sub, (nmod_poly_t res, const nmod_poly_t poly1, const nmod_poly_t poly2),
        (res, poly1, poly2))
}
