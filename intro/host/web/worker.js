// A worker of the page. It receives messages [name, arguments...], and posts objects whose members are the results.
const kPage = 65536
let module, x, w, h, turn // turn: number of seeks
const bytes = () => new Uint8Array(x.memory.buffer)
const page = i => bytes().subarray(i * kPage, (i + 1) * kPage)
// Returns the numbers of the pages of memory that are not empty
const used = () => {
  const all = new Int32Array(x.memory.buffer), size = kPage / 4, which = []
  for (let i = 0; i < all.length; i += size) {
    let k = i
    while (k < i + size && !all[k]) ++k
    if (k < i + size) which.push(i / size)
  }
  return which
}
const make = () => {
  x = new WebAssembly.Instance(module, { env: { progress: done => postMessage({ progress: done }) } }).exports
}
const text = at => { let s = ''; for (const b = bytes(); b[at]; ) s += String.fromCharCode(b[at++]); return s }
const load = hall => { const at = x.load(w, h, hall); if (at) postMessage({ wrong: text(at) }); return !at }
const handlers = {
  // Works for `ms` milliseconds, and posts the rounds in a millisecond (and the result, so that it is computed). Each
  // step waits for the one before, so two threads of one processor do not slow each other down
  spin(ms) {
    let rounds = 0, v = 1, t
    const began = performance.now()
    for (; (t = performance.now() - began) < ms; ++rounds)
      for (let i = 0; i < 1e4; ++i) v = Math.imul(v, 747796405) + 1 | 0
    postMessage([rounds / t, v])
  },
  trace(m, width, height) {
    module = m, w = width, h = height
    make()
    if (load(0)) postMessage({ idle: 1 })
  },
  // Traces the picture that plan() of main_web.cpp describes, into `rgba`
  picture(p, rgba = new Uint8Array(w * h * 4)) {
    const began = performance.now(), at = x.picture(p.time, p.level, p.width, p.height)
    const trace = performance.now() - began, width = p.width || w, height = p.height || h
    rgba.set(bytes().subarray(at, at + w * h * 4))
    postMessage({ ...p, rgba, trace, width, samples: x.samples() / width / height }, [rgba.buffer])
  },
  // Solves the hall's light, and posts the pages of its memory that are not empty
  solve(m, width, height) {
    module = m, w = width, h = height
    make()
    if (!load(1)) return
    const which = used(), pages = new Uint8Array(which.length * kPage)
    which.forEach((i, k) => pages.set(page(i), k * kPage))
    postMessage({ hall: { which, pages, count: bytes().length / kPage } }, [pages.buffer])
  },
  // Copies these pages to this worker's memory, and posts them for the next worker
  light(hall) {
    for (const i of used()) page(i).fill(0)
    x.memory.grow(hall.count - bytes().length / kPage)
    hall.which.forEach((i, k) => page(i).set(hall.pages.subarray(k * kPage, (k + 1) * kPage)))
    postMessage({ hall }, [hall.pages.buffer])
  },
  compose(m, ...all) {
    module = m
    make()
    handlers.seek(...all)
  },
  seek(block, t) {
    turn = t
    if (!x.seek(block)) postMessage({ wrong: 'not enough memory' })
  },
  sound(blocks) {
    const n = blocks * x.block(), all = new Float32Array(x.memory.buffer, x.sound(blocks), 2 * n)
    const left = new Float32Array(n), right = new Float32Array(n)
    for (let i = 0; i < n; ++i) left[i] = all[2 * i], right[i] = all[2 * i + 1]
    postMessage({ left, right, turn }, [left.buffer, right.buffer])
  },
}
onmessage = ({ data: [what, ...all] }) => handlers[what](...all)
