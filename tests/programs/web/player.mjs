// node player.mjs PROGRAM.wasm SCRIPTS.js...: plays page.js in a simulated browser, whose workers take a stated time
// for each picture, and checks what is shown. Every machine gives the same results.
import { readFileSync } from 'node:fs'

const [program, ...scripts] = process.argv.slice(2)
const kWorkers = 2, kSeconds = 8

// `cost`: milliseconds that a worker takes for a picture of 1280x720 in `draft`. Returns the milliseconds from the
// click to the first picture; the number of pictures left out after 1.5 s; the fewest that were shown in a second; how
// far the sound was off, in seconds; whether keys mute it; the number of workers; the most locks of the screen at once;
// the error of the place sought, with the locks meanwhile; and how often the poster was shown. `pauses`: the system
// stops the sound from 3 to 7 s after the click. `silent`: the browser has no sound. `dark`: the hall's worker fails
// with this event. `broken`: the workers that measure do. `resized`: the page has another size at the click, and ESC
// follows. `stops`: the viewer pauses with a click, and continues with space. `seeks`: the viewer pauses, seeks by
// these seconds, and continues. `loops`: the viewer presses L. `late`: the sound starts 3 s after the click. `stands`:
// the sound's clock stands for 1.5 s, soon after the start. `lags`: it runs at half the speed for 2 s. `reported`,
// `processors`: the number that the browser reports, and that there are.
const play = async (cost, from, { pauses, silent, dark, broken, resized, stops, seeks, loops, late, stands,
  lags, reported = kWorkers, processors = reported, query = from } = {}) => {
  let clock = 0, skippedAtStart = 0, off = 0, context, muted, tracers = 0, spinning = 0, spun
  const events = [], shown = [], elements = {}
  const at = (when, what) => { events.push({ when, what }), events.sort((a, b) => a.when - b.when) }
  const element = () => ({ style: {}, getContext: () => ({ fillRect() {}, putImageData: p => shown.push(p.time) }) })
  class Picture { constructor({ time }) { this.time = time } }
  class Worker {
    free = 0
    postMessage([what, ...all]) {
      let t = Math.max(clock, this.free)
      const send = (ms, data) => at(t += ms, () => this.onmessage?.({ data }))
      if (what == 'spin' && broken) return at(t, () => this.onerror(broken))
      if (what == 'spin') { // workers that spin at the same time share the processors
        spinning = clock == spun ? spinning + 1 : 1, spun = clock
        at(t += all[0], () => this.onmessage({ data: [1e6 * Math.min(1, processors / spinning)] }))
      }
      if (what == 'trace') send(300, { idle: 1 }), ++tracers
      if (what == 'solve' && dark) at(t += 800, () => this.onerror(dark))
      else if (what == 'solve') send(8000, { hall: { pages: [] } })
      if (what == 'light') send(20, { hall: all[0] })
      if (what == 'compose' || what == 'seek') this.turn = all.at(-1)
      if (what == 'sound') send(10, { left: [], right: [], turn: this.turn })
      if (what == 'picture') {
        const [p] = all, width = p.width || 1280, trace = cost * (width / 1280) ** 1.7 * 2 ** (2 - p.level)
        send(trace, { ...p, trace, width, samples: 1, rgba: { buffer: p } })
      }
      this.free = t
    }
    terminate() { this.onmessage = null }
  }
  const stood = ms => stands && ms > 600 ? Math.max(600, ms - 1500) : lags && ms > 600
    ? ms - Math.min(1000, (ms - 600) / 2) : ms
  class AudioContext {
    state = 'suspended'
    ran = 0
    constructor() { context = this }
    get currentTime() { return (this.ran + (this.state == 'running' && stood(clock - this.begun))) / 1e3 }
    resume() {
      at(clock + (late ? 3000 : 100), () => {
        this.state == 'running' || (this.begun = clock), this.state = 'running'
      })
    }
    suspend() { this.ran = 1e3 * this.currentTime, this.state = 'suspended' }
    close() {}
    gain = { value: 1 }
    createGain() { return { gain: this.gain, connect() {}, disconnect() {} } }
    createBuffer() { return { copyToChannel() {} } }
    createBufferSource() { return { connect() {}, start() {} } }
  }
  let locks = 0, mostLocks = 0
  const wakeLock = { async request() {
    mostLocks = Math.max(mostLocks, ++locks)
    return { release() { --locks } }
  } }
  const self = {
    WebAssembly, Worker, AudioContext: silent ? undefined : AudioContext, Uint8ClampedArray: Picture,
    ImageData: Picture, Blob: class {}, URL: { createObjectURL() {} }, performance: { now: () => clock },
    location: { search: `?full=0&from=${query}` },
    document: { querySelector: s => elements[s] ??= element(), body: {} },
    navigator: { hardwareConcurrency: reported, wakeLock },
    innerWidth: 1280, innerHeight: 720, devicePixelRatio: 1,
    cancelAnimationFrame() {}, requestAnimationFrame: f => at(Math.floor(clock * 0.06 + 1.001) / 0.06, () => f(clock)),
  }
  const text = scripts.map(s => readFileSync(s, 'utf8')).join('')
  let ready
  new Function('self', `with (self) { ${text}; return main }`)(new Proxy(self, {
    has: (o, k) => k in o || /^on/.test(k), get: (o, k) => k == 'self' ? self : o[k],
  }))(readFileSync(program), '').then(() => ready = 1)
  for (; !ready; await new Promise(setImmediate)) if (events.length) {
    const { when, what } = events.shift()
    clock = when, what()
  }
  if (!self.film) return { word: elements.p.textContent }
  at(12000, () => self.onclick())
  if (resized) at(11999, () => self.innerWidth = 1000), at(12010, () => press('Escape'))
  if (pauses) at(15000, () => context.suspend()), at(19000, () => context.resume())
  let moved = 0
  const film = () => self.film.state().film
  if (stops || seeks) at(14000, () => { self.onclick(), moved -= film() }), at(16000, () => moved += film())
  if (stops) at(16010, () => press(' '))
  const press = (key, code = key, more) => self.onkeydown({ key, code, ...more })
  let sought
  if (stops || seeks) at(15000, () => sought = locks)
  if (seeks) {
    at(16010, () => {
      sought += seeks.reduce((t, by) => Math.max(from, t + by), film())
      const keys = seeks.map(by => by < 0 ? 'ArrowLeft' : 'ArrowRight')
      for (const key of keys) press(key), press(key, key, { repeat: true })
    })
    at(18000, () => { sought -= (film() + shown.at(-1)) / 2, press(' ') })
  }
  if (loops) at(12600, () => press('l', 'KeyL'))
  const keys = [['m', 'KeyM'], ['M', 'KeyM'], ['\u044c', 'KeyM'], ['M', 'Semicolon']]
  at(12600, () => muted = keys.map(([key, code]) => { press(key, code); return context?.gain.value }) + '')
  const each = Array(kSeconds).fill(0)
  let last, sounds, begun
  for (let film = -1, played; film < from + kSeconds; ) {
    const { when, what } = events.shift()
    clock = when
    what()
    await null
    const s = self.film.state()
    begun ||= film > s.film && film > 0
    film = s.film
    if (film < from + (late || stands || lags ? 5 : 1.5)) skippedAtStart = s.skipped
    else if (s.heard != null) off = Math.max(off, Math.abs(s.heard - film))
    if (s.over || played && !s.playing || begun && loops && film % 1 > 0.5 && film % 1 < 0.8) break
    played = s.playing
    if (played) last = shown.at(-1), sounds = s.heard != null
  }
  for (const t of shown) if (t >= from && t < from + kSeconds) ++each[Math.floor(t - from)]
  const { first, skipped, duration, unlit, over } = self.film.state()
  const least = Math.min(...each.slice(0, Math.ceil(last - from)))
  return { first, skipped: skipped - skippedAtStart, least, off, last, muted, duration, moved, sounds, unlit, over,
    tracers, locks: mostLocks, sought, posters: shown.filter(t => t == 35).length }
}

let wrong = false
const report = (right, what, seen) => {
  console.log(`${right ? 'ok' : 'FAILED'}: ${what}: ${JSON.stringify(seen)}`)
  wrong ||= !right
}
const check = async (cost, from, how = {}) => {
  const r = await play(cost, from, how), last = Math.min(from + kSeconds, r.duration) - 0.1
  const right = r.first <= (how.silent || how.late ? 2600 : 500) && !r.skipped && r.least >= 24 &&
    r.off < (how.lags ? 0.25 : 0.02) && !r.moved && r.last >= last && r.sounds == !how.silent &&
    r.locks == 1 && Math.abs(r.sought ?? 0) < 0.02 && r.posters == (r.last > r.duration - 0.1 ? 2 : 1) &&
    r.muted == (how.silent ? ',,,' : '0,1,0,1')
  report(right, `${cost} ms a picture, from ${from} s ${Object.keys(how)}`, r)
}
for (const cost of [60, 120, 240]) for (const from of [0, 20, 46, 66, 96, 130, 153]) await check(cost, from)
const kTwists = [{ pauses: 1 }, { silent: 1 }, { stops: 1 }, { stops: 1, silent: 1 }, { late: 1 }, { stands: 1 },
  { lags: 1 }]
for (const twist of kTwists) await check(120, 46, twist)
for (const seeks of [[-5], [5, -5]]) await check(120, 66, { seeks })
for (const [query, from] of [['1e9', 163], ['-5', 0], ['60,5', 60], ['x', 0]]) await check(120, from, { query })
// A browser that reports other processors than there are
const kMachines = [[4, 2, 2], [8, 3, 3], [4, 4, 4], [4, 3.4, 4], [4, 0.9, 2], [1, 1, 1], [64, 64, 8]]
for (const [reported, processors, workers] of kMachines) {
  const { tracers } = await play(60, 162, { reported, processors })
  report(tracers == workers, `workers of ${reported} processors reported, ${processors} there`, tracers)
}
// Workers that fail. From half a second before the hall: its scenes are left out, with the reason, and the film goes on
for (const event of [{ message: 'memory' }, new Event('error')]) {
  const why = event.message ?? 'the browser could not run a worker'
  const dark = await play(60, 63.5, { dark: event }), { word } = await play(120, 0, { broken: event })
  const told = dark.unlit.includes(`(${why})`) && dark.last < 64 && !dark.over && word.endsWith('stopped: ' + why)
  report(told, `workers that fail: ${word}`, dark)
}
const again = await play(120, 162, { loops: 1 })
report(Math.floor(again.last) == 162 && !again.over, 'begins again', again)
const { posters } = await play(120, 0, { resized: 1 })
report(posters == 1, 'posters after another size', posters)
process.exit(wrong ? 1 : 0)
