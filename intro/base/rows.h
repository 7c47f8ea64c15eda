// Tables with a row for every enumerator. Rows are found by index; the compiler checks their order.
#pragma once

namespace odraz {

// Whether a table has a row for every enumerator before `count` (Id::Count where the enum is a class), in the
// enum's order. `id` is the member that holds a row's enumerator.
template <class Row, class Id, int N>
consteval bool inOrder(const Row (&rows)[N], Id Row::*id, int count = (int)Id::Count) {
    for (int i = 0; i < N; ++i)
        if (rows[i].*id != (Id)i) return false;
    return N == count;
}

} // namespace odraz
