// The film as a page: main() gets the program (main_web.cpp) as bytes, and the scripts of its workers as text. Times are
// seconds of the film, or milliseconds (t) of the page's clock.
const find = selector => document.querySelector(selector), now = () => performance.now()
const canvas = find('canvas'), bar = find('i'), button = find('button'), word = find('p'), printed = find('pre')
// In memory: WebKit would draw by OpenGL, which without a GPU takes a third of the workers' time
const draw = canvas.getContext('2d', { alpha: false, willReadFrequently: true })
const q = new URLSearchParams(location.search), full = q.get('full') != '0'
// x: the functions of the page's instance; from: where the film begins, at first and after its end at `begins`; over:
// something has failed
let x, module, url, duration, begins, from, over
// playing: from the click to the end; since: when waiting for pictures began; clicked: the click's time; loops: at its
// end the film begins again; frame: the next call of step()
let playing, since, clicked, loops, frame
const say = text => { if (word.textContent != text) word.textContent = text }
const fail = what => { over = 1; button.textContent = ''; awake(0); say(what) }
// The reason that an error, an event or a text gives. An event of a worker may have no message
const reason = e => e.message || (e.type ? 'the browser could not run a worker' : e)
const stop = e => fail('The film has stopped: ' + reason(e))
// Makes a callback that catches its errors. The page's own events also report errors of other scripts (extensions)
const own = f => async (...all) => { try { await f(...all) } catch (e) { stop(e) } }

// --- The film's clock, which stops while `holds` has a reason or the system has stopped the sound ---
const holds = new Set, kPaused = '\u275a\u275a', kSolving = 'The light of the hall is being solved.'
let stopped, going, begun // stopped: the film's time while it is stopped; begun: its first pictures are ready
const filmAt = () => !begun ? -1e9 : going ? x.at(now()) : stopped
// Keeps the screen on, or phones would sleep. `lock`: a promise
let lock
const awake = on => {
  if (!on == !lock) return
  lock?.then(l => l?.release())
  lock = on ? navigator.wakeLock?.request('screen').catch(() => {}) : null
}
const check = () => {
  const t = now(), goes = begun && !holds.size && (silent || audio.state == 'running')
  if (!goes == !going) return
  awake(goes)
  if (!(going = goes)) return stopped = x.at(t)
  x.start(stopped - (silent ? 0 : 0.1), t)
  settled = t + 400
  say('')
}
const hold = why => {
  if (!holds.size) audio?.suspend()
  holds.add(why), check()
}
const release = why => {
  if (!holds.delete(why)) return
  if (why == 'start') begun = 1
  if (holds.size) return
  if (zero == null && !silent) zero = audio.currentTime + 0.1, schedule()
  audio?.resume(), check()
}

// --- Each refresh of the screen ---
const sounds = () => audio?.state == 'running' && audio.currentTime > 0.25 // some clocks start, and stand for a second
const begin = t => {
  const needs = x.can(from) == kLater, share = x.ready()
  bar.style.width = 100 * (needs ? solved * 0.8 : 0.8 + share / 5) + '%'
  say(needs ? kSolving : holds.has('pause') ? kPaused : '')
  if (!sounds() && t - since > 2500) silent = 1
  const audible = silent || sounds() && waiting.length > 3
  if (audible && (share == 1 || x.can(from) == kNever)) {
    bar.style.width = 0
    if (holds.has('pause')) showDue(from, t)
    release('start')
  }
}
const step = own((t = now()) => {
  if (over) return
  check()
  if (silent && sounds()) silent = 0, seek(0) // it was slow to start
  if (holds.has('start')) begin(t)
  else if (going) {
    if (!silent && audio.currentTime > zero && audio.currentTime != heard) {
      if (t - moved > 300 || Math.abs(heardAt(t) - x.at(t)) > 0.25) settled = t + 400
      heard = audio.currentTime, moved = t
      t < settled ? x.start(heardAt(t), t) : x.correct(heardAt(t), t)
    }
    const film = x.at(t), state = x.can(Math.max(film, from))
    if (film >= duration) {
      if (!loops) return end()
      seek(-duration)
    }
    if (state == kLater) hold('hall')
    say(state == kNever ? unlit : '')
    if (state == kNever) draw.fillRect(0, 0, w, h)
    showDue(film, t)
  } else if (holds.has('hall')) {
    say(kSolving)
    bar.style.width = 100 * solved + '%'
  } else if (holds.has('pause')) say(kPaused)
  compose()
  assign()
  frame = requestAnimationFrame(step)
})
const statistics = () => {
  const b = new Uint8Array(x.memory.buffer, x.statistics((first - clicked) / 1e3), 4096)
  return new TextDecoder().decode(b.slice(0, b.indexOf(0)))
}
// Shows the poster again, and prepares the film's beginning
const end = () => {
  cancelAnimationFrame(frame)
  if (q.has('stats')) printed.textContent = statistics()
  audio?.close()
  awake(silent = 0)
  audio = null
  document.exitFullscreen?.().catch(() => {})
  document.body.className = ''
  bar.style.width = playing = 0
  say('')
  go(begins)
  holds.clear()
  if (poster) paint(poster)
  compose(), assign()
}

// --- The viewer ---
const fullScreen = () => full && document.documentElement.requestFullscreen?.()
  .then(() => screen.orientation.lock('landscape')).catch(() => {}) // phones rotate the page; other devices refuse
const play = () => {
  if (over) return
  if (playing) return pause()
  prepare()
  playing = 1, shown = 0, clicked = since = now()
  document.body.className = 'on'
  draw.fillRect(0, 0, w, h)
  openSound()
  fullScreen() // in WebKit a click that has filled the screen starts no sound
  holds.add('start')
  step()
}
const pause = () => {
  if (holds.has('pause')) release('pause')
  else if (going) hold('pause')
  else if (!holds.size) audio?.resume() // the system has stopped the sound
}
const go = to => {
  from = stopped = Math.max(begins, Math.min(to, duration - 1))
  going = begun = 0, since = now()
  holds.delete('hall'), holds.add('start')
  ++turn, beginPictures(), seekMusic()
}
const seek = by => playing && !over && go((begun ? filmAt() : from) + by)
const key = e => {
  // Some events of other scripts have no key
  if (!e.key || e.repeat || e.ctrlKey || e.altKey || e.metaKey) return
  // The key's letter, or its place on the keyboard
  const is = letter => [e.key.toUpperCase(), e.code?.slice(3)].includes(letter)
  if ((e.key == 'Enter' || e.key == ' ') && e.target != button) play() // the button is clicked by them
  if (e.key == 'ArrowLeft') seek(-5)
  if (e.key == 'ArrowRight') seek(5)
  if (is('M') && gain) gain.gain.value = 1 - gain.gain.value
  if (is('L')) loops = !loops
  if (is('F')) document.fullscreenElement ? document.exitFullscreen() : fullScreen()
  if (e.key == 'Escape' && playing) end()
}
// Whether the browser accepts this code in a function without parameters that returns a vector
const can = code => {
  const body = [1, code.length + 2, 0, ...code, 11]
  const parts = [0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, body.length, ...body]
  return WebAssembly.validate(new Uint8Array(parts))
}
const main = own(async (wasm, scripts) => {
  const kZero = [65, 0, 253, 15] // i32.const 0, i8x16.splat
  if (!can(kZero)) return fail('This browser has no WebAssembly SIMD.')
  module = await WebAssembly.compile(can([...kZero, ...kZero, ...kZero, 253, 133, 2]) ? wasm : plain(wasm))
  x = (await WebAssembly.instantiate(module, { env: { progress() {} } })).exports
  url = URL.createObjectURL(new Blob([scripts], { type: 'text/javascript' }))
  duration = x.duration(), count = await measureWorkers(x.workers(cores))
  begins = from = stopped = Math.max(0, Math.min(parseFloat(q.get('from')) || 0, duration - 1))
  prepare()
  startComposer()
  compose()
  onclick = own(play)
  onkeydown = own(key)
  document.onvisibilitychange = own(() => {
    if (playing && !over) document.hidden ? hold('hidden') : release('hidden')
  })
  button.textContent = '\u25b6 play'
  if (q.has('stats')) setInterval(own(() => { if (shown && playing) printed.textContent = statistics() }), 1000)
  // For tests
  const state = () => ({
    film: filmAt(), heard: zero != null && audio.state == 'running' ? heardAt(now()) : null, ready: pictures.size,
    shown, skipped, first: first - clicked, unlit, hall: lit >= count, over, duration, playing,
  })
  self.film = { module, start: startWorker, statistics, state }
  if (self.clicked) play()
})
