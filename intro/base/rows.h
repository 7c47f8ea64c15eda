// Tables with a row for every enumerator: found by index, checked when compiled.
#pragma once

namespace odraz {

// Whether a table has a row for every enumerator before Count, in the enum's order; `id` is the member that
// names the row's own.
template <class Row, class Id, int N> consteval bool inOrder(const Row (&rows)[N], Id Row::*id) {
    for (int i = 0; i < N; ++i)
        if (rows[i].*id != (Id)i) return false;
    return N == (int)Id::Count;
}

} // namespace odraz
