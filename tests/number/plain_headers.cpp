// Headers that users include show no intervals: CGAL and its flags are the library's own. What follows fails
// to compile otherwise.
#include "bezcert/algebra/algebraic_point.hpp"
#include "bezcert/algebra/fiber.hpp"
#include "bezcert/algebra/real_root.hpp"
#include "bezcert/algebra/zero_set.hpp"
#include "bezcert/bernstein/shape.hpp"
#include "bezcert/element/element.hpp"
#include "bezcert/io/mesh/read.hpp"
#include "bezcert/number/dyadic.hpp"
#include "bezcert/number/exact_vector.hpp"
#include "bezcert/number/parse.hpp"
#include "bezcert/number/rational.hpp"

#ifdef CGAL_INTERVAL_NT_H
#error "a header that users include shows intervals"
#endif
