// node player.mjs PROGRAM.wasm SCRIPTS.js...: plays page.js in a browser of fakes, whose clock is simulated and whose
// workers take a stated time for each picture. Checks what is shown, on any machine alike.
import { readFileSync } from 'node:fs'

const [program, ...scripts] = process.argv.slice(2)
const kWorkers = 2, kSeconds = 8

// `cost`: milliseconds that a worker takes for all of 1280x720 pixels in `draft`. Returns the milliseconds from the
// click to the first picture, how many were left out after 1.5 s, the fewest that were shown in a second, and how far the
// sound was off, in seconds.
const play = async (cost, from) => {
  let clock = 0, skippedAtStart = 0, off = 0
  const events = [], shown = [], elements = {}
  const at = (when, what) => { events.push({ when, what }), events.sort((a, b) => a.when - b.when) }
  const element = () => ({ style: {}, getContext: () => ({ fillRect() {}, putImageData: p => shown.push(p.time) }) })
  class Picture { constructor({ time }) { this.time = time } }
  class Worker {
    free = 0
    postMessage([what, ...all]) {
      let t = Math.max(clock, this.free)
      const send = (ms, data) => at(t += ms, () => this.onmessage?.({ data }))
      if (what == 'trace') send(300, { idle: 1 })
      if (what == 'solve') send(8000, { hall: { pages: [] } })
      if (what == 'light') send(20, { hall: all[0] })
      if (what == 'sound') send(10, { left: [], right: [] })
      if (what == 'picture') {
        const [p] = all, width = p.width || 1280, trace = cost * (width / 1280) ** 1.7 * 2 ** (2 - p.level)
        send(trace, { ...p, trace, width, samples: 1, rgba: { buffer: p } })
      }
      this.free = t
    }
    terminate() { this.onmessage = null }
  }
  class AudioContext {
    state = 'suspended'
    get currentTime() { return this.begun ? (clock - this.begun) / 1e3 : 0 }
    resume() { at(clock + 100, () => { this.begun ??= clock, this.state = 'running' }) }
    createGain() { return { connect() {} } }
    createBuffer() { return { copyToChannel() {} } }
    createBufferSource() { return { connect() {}, start() {} } }
  }
  const self = {
    WebAssembly, Worker, AudioContext, Uint8ClampedArray: Picture, ImageData: Picture, Blob: class {},
    URL: { createObjectURL() {} }, location: { search: `?full=0&from=${from}` }, performance: { now: () => clock },
    document: { querySelector: s => elements[s] ??= element(), body: {} }, navigator: { hardwareConcurrency: kWorkers },
    innerWidth: 1280, innerHeight: 720, devicePixelRatio: 1,
    requestAnimationFrame: f => at(Math.floor(clock * 0.06 + 1.001) / 0.06, () => f(clock)),
  }
  const text = scripts.map(s => readFileSync(s, 'utf8')).join('')
  await new Function('self', `with (self) { ${text}; return main }`)(new Proxy(self, {
    has: (o, k) => k in o || /^on/.test(k), get: (o, k) => k == 'self' ? self : o[k],
  }))(readFileSync(program), '')
  at(12000, () => self.onclick())
  const each = Array(kSeconds).fill(0)
  for (let film = -1; film < from + kSeconds; ) {
    const { when, what } = events.shift()
    clock = when
    what()
    await null
    const s = self.film.state()
    film = s.film
    if (film < from + 1.5) skippedAtStart = s.skipped
    else off = Math.max(off, Math.abs(s.heard - film))
  }
  for (const t of shown) if (t >= from && t < from + kSeconds) ++each[Math.floor(t - from)]
  const { first, skipped } = self.film.state()
  return { first, skipped: skipped - skippedAtStart, least: Math.min(...each), off }
}

let wrong = false
for (const cost of [60, 120, 240])
  for (const from of [0, 20, 46, 66, 96, 130, 153]) {
    const r = await play(cost, from), right = r.first <= 300 && !r.skipped && r.least >= 24 && r.off < 0.02
    console.log(`${right ? 'ok' : 'FAILED'}: ${cost} ms a picture, from ${from} s: ${JSON.stringify(r)}`)
    wrong ||= !right
  }
process.exit(wrong ? 1 : 0)
