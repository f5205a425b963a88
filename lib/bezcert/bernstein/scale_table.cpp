#include "bezcert/bernstein/scale_table.hpp"

#include "bezcert/bernstein/table_cache.hpp"

namespace bezcert {

const ScaleTable& scale_table(Shape shape) {
  static TableCache<ScaleTable> cache;
  return cache.get(shape, [](Shape s) {
    ScaleTable table;
    table.multinomial = multinomials(s);
    table.multiple = 1;
    for (const Integer& m : table.multinomial) table.multiple = lcm(table.multiple, m);
    for (const Integer& m : table.multinomial) {
      table.cofactor.push_back(table.multiple / m);
      table.multinomial_interval.push_back(to_interval(m));
      table.cofactor_interval.push_back(to_interval(table.cofactor.back()));
    }
    return table;
  });
}

}  // namespace bezcert
