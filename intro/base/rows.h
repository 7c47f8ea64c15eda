// Tables with one row for each enumerator, indexed by it. The compiler checks the order of the rows.
#pragma once

namespace odraz {

// Returns whether a table has one row for each enumerator below `count`, in the order of the enum. `count` is
// Id::Count if the enum is a class. `id` is the member of a row that holds its enumerator.
template <class Row, class Id, int N>
consteval bool inOrder(const Row (&rows)[N], Id Row::*id, int count = (int)Id::Count) {
    for (int i = 0; i < N; ++i)
        if (rows[i].*id != (Id)i) return false;
    return N == count;
}

} // namespace odraz
