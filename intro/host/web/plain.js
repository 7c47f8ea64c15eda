// A program for browsers without relaxed SIMD, made of one with it: what it multiplies and adds is rounded twice.
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
  // One more local holds the last operand of a multiply-add
  const rewrite = (to, type) => {
    const body = [], size = number(), end = i + size, groups = number(), from = i
    let local = types[type]
    for (let n = groups; n--; ++i) local += number()
    put(body, groups + 1), copy(body, wasm.slice(from, i)), body.push(1, 123)
    while (i < end) {
      const from = i, op = wasm[i++], code = op > 251 && number()
      let n = 0, raw = 0
      if (op == 253) {
        n = code < 12 || code > 83 && code < 94 ? 2 : 0
        raw = code == 12 || code == 13 ? 16 : code > 20 && code < 35 || code > 83 && code < 92 ? 1 : 0
      } else if (op == 252)
        n = code > 7 ? 2 - (code == 11) : 0
      else {
        n = op == 14 ? number() + 1 : op == 17 || op > 39 && op < 63 ? 2
          : op > 1 && op < 5 || op > 11 && op < 17 && op != 15 || op > 31 && op < 37 || op > 62 && op < 67 ? 1 : 0
        raw = op == 67 ? 4 : op == 68 ? 8 : 0
      }
      while (n--) number()
      skip(raw)
      if (op == 253 && code == 261)
        body.push(33), put(body, local), body.push(253, 230, 1, 32), put(body, local), body.push(253, 228, 1)
      else
        copy(body, op == 253 && code == 267 ? [253, 82] : op == 253 && code == 257 ? [253, 248, 1]
          : wasm.slice(from, i))
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
