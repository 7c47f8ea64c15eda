// Converts a program with relaxed SIMD for browsers without it: a multiply-add is then rounded twice. It finds the
// instructions by their bytes: packer/web/page.cpp has checked that no other bytes look like them.
const plain = wasm => {
  let i = 8
  const out = [...wasm.slice(0, i)], types = [], functions = []
  const number = () => {
    let v = 0, shift = 0, c
    do c = wasm[i++], v |= (c & 127) << shift, shift += 7
    while (c > 127)
    return v
  }
  const put = (to, v) => {
    for (; v > 127; v >>>= 7) to.push(v & 127 | 128)
    to.push(v)
  }
  const copy = (to, from) => { for (const b of from) to.push(b) }
  const each = f => { for (let n = number(); n--; ) f() }
  const skip = n => { i += n }
  // Add a local to each function, for the last operand of a multiply-add
  const rewrite = (to, type) => {
    const body = [], size = number(), end = i + size, groups = number(), from = i, operand = []
    let local = types[type]
    for (let n = groups; n--; ++i) local += number()
    put(operand, local)
    put(body, groups + 1), copy(body, wasm.slice(from, i)), body.push(1, 123)
    const add = [33, ...operand, 253, 230, 1, 32, ...operand, 253, 228, 1]
    const instead = { 129: [253, 248, 1], 133: add, 139: [253, 82] }
    while (i < end) {
      const relaxed = wasm[i] == 253 && wasm[i + 2] == 2 && instead[wasm[i + 1]]
      relaxed ? copy(body, relaxed) : body.push(wasm[i])
      i += relaxed ? 3 : 1
    }
    put(to, body.length), copy(to, body)
  }
  while (i < wasm.length) {
    const id = wasm[i++], size = number(), from = i, end = i + size
    let body = wasm.slice(i, end)
    if (id == 1) each(() => { ++i; const n = number(); skip(n), types.push(n); skip(number()) })
    if (id == 3) each(() => functions.push(number()))
    if (id == 10) {
      number()
      put(body = [], functions.length)
      for (const type of functions) rewrite(body, type)
    }
    out.push(id), put(out, body.length), copy(out, body)
    i = end
  }
  return new Uint8Array(out)
}
