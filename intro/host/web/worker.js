// What a worker of the page does. Messages in: [what, ...]; out: objects, whose members say what they are.
const work = () => {
  const kPage = 65536
  let module, x, w, h, held, slot = 0
  const bytes = () => new Uint8Array(x.memory.buffer)
  const make = gl => {
    const env = { progress: done => postMessage({ progress: done }) }
    const all = new Proxy(env, { get: (o, k) => o[k] ?? gl?.[k] ?? (() => 0) })
    x = new WebAssembly.Instance(module, { env: all }).exports
    held = -1
  }
  const text = at => { let s = ''; for (const b = bytes(); b[at]; ) s += String.fromCharCode(b[at++]); return s }
  const load = hall => { const at = x.load(w, h, 1, hall); if (at) postMessage({ wrong: text(at) }); return !at }
  // Makes something; how many milliseconds that took
  const timed = make => { const began = performance.now(); make(); return performance.now() - began }
  const send = (more, at) => {
    const rgba = bytes().slice(at, at + w * h * 4)
    postMessage({ ...more, rgba }, [rgba.buffer])
  }
  const does = {
    trace(m, width, height) {
      module = m, w = width, h = height
      make()
      if (load(0)) postMessage({ idle: 1 })
    },
    still(time, level) {
      held = -1
      send({ still: time }, x.picture(0, time, level, 0, 0))
      postMessage({ idle: 1 })
    },
    // Makes the run that plan() of main_web.cpp describes
    run(r) {
      let trace = 0, make = 0, made = 0, last = r.before, at
      const traceAt = time => timed(() => at = x.picture(slot ^= 1, held = time, r.level, r.width, r.height))
      if (last >= 0 && held != last) trace += traceAt(last)
      for (let i = 0; i < r.traced; ++i) {
        const time = r.time + i * r.step, ms = traceAt(time), width = r.width || w
        const picture = { time, trace: ms, width, samples: x.samples() / width / (r.height || h) }, its = at
        trace += ms
        for (let k = 1; last >= 0 && k <= r.between; ++k, ++made) {
          const share = k / (r.between + 1), ms = timed(() => at = x.between(slot ^ 1, slot, share))
          make += ms
          send({ time: last + (time - last) * share, make: ms }, at)
        }
        send(picture, its)
        last = time
      }
      postMessage({ idle: 1, trace, make, made, run: r })
    },
    // Solves the hall's light, and posts the pages of its memory that are not empty
    solve(m, width, height) {
      module = m, w = width, h = height
      const gl = self.OffscreenCanvas && new OffscreenCanvas(1, 1).getContext('webgl2', { antialias: false })
      if (!gl) return postMessage({ wrong: 'no WebGL 2' })
      make(makeGl(gl, () => x.memory.buffer))
      if (!load(1)) return
      const all = new Int32Array(x.memory.buffer), each = kPage / 4, which = []
      for (let i = 0; i < all.length; i += each) {
        let k = i
        while (k < i + each && !all[k]) ++k
        if (k < i + each) which.push(i / each)
      }
      const pages = new Uint8Array(which.length * kPage)
      which.forEach((i, k) => pages.set(bytes().subarray(i * kPage, (i + 1) * kPage), k * kPage))
      postMessage({ hall: { which, pages, count: all.length / each } })
    },
    light({ which, pages, count }) {
      make()
      x.memory.grow(count - x.memory.buffer.byteLength / kPage)
      const to = bytes()
      which.forEach((i, k) => to.set(pages.subarray(k * kPage, (k + 1) * kPage), i * kPage))
    },
    compose(m, block) {
      module = m
      make()
      if (!x.seek(block)) postMessage({ wrong: 'there is not enough memory' })
    },
    sound(blocks) {
      const n = blocks * 240, all = new Float32Array(x.memory.buffer, x.sound(blocks), 2 * n)
      const left = new Float32Array(n), right = new Float32Array(n)
      for (let i = 0; i < n; ++i) left[i] = all[2 * i], right[i] = all[2 * i + 1]
      postMessage({ left, right }, [left.buffer, right.buffer])
    },
  }
  onmessage = ({ data: [what, ...all] }) => does[what](...all)
}
