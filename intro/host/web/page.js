// The film as a page: main() gets the program (main_web.cpp) as bytes, and the scripts of its workers as text.
const main = async (wasm, scripts) => {
  const of = selector => document.querySelector(selector), body = document.body
  const canvas = of('canvas'), bar = of('i'), button = of('b'), word = of('p'), printed = of('pre')
  const q = new URLSearchParams(location.search), now = () => performance.now()
  const kRate = 48000, kBlock = 240
  let over
  const say = text => word.textContent = text
  const fail = what => { over = 1; button.textContent = ''; say(what) }
  onerror = onunhandledrejection = e => fail('The film has stopped: ' + (e.reason?.message ?? e.message ?? e))

  // --- What the browser lacks ---
  const can = code => { // a function of no parameters that returns a vector
    const body = [1, code.length + 2, 0, ...code, 11]
    const parts = [0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, body.length, ...body]
    return WebAssembly.validate(new Uint8Array(parts))
  }
  const kZero = [65, 0, 253, 15] // i32.const 0, i8x16.splat
  if (!can(kZero)) return fail('This browser has no WebAssembly SIMD.')
  const relaxed = can([...kZero, ...kZero, ...kZero, 253, 133, 2])
  const module = await WebAssembly.compile(relaxed ? wasm : plain(wasm))
  const x = (await WebAssembly.instantiate(module, { env: new Proxy({}, { get: () => () => 0 }) })).exports

  // --- Workers ---
  const cores = navigator.hardwareConcurrency || 2, count = Math.min(cores, 8), most = cores > 4 ? 1920 : 1280
  const full = q.get('full') != '0', dpr = devicePixelRatio || 1
  let w, h, tracers = [], solver
  const draw = canvas.getContext('2d', { alpha: false })
  const url = URL.createObjectURL(new Blob([scripts], { type: 'text/javascript' }))
  const start = (heard, ...first) => {
    const k = new Worker(url)
    k.onerror = e => fail('The film has stopped: ' + e.message)
    k.onmessage = ({ data }) => data.wrong ? (k == solver ? leaveOut : fail)(data.wrong) : heard(data, k)
    k.postMessage(first)
    return k
  }
  const paint = rgba => draw.putImageData(new ImageData(new Uint8ClampedArray(rgba.buffer), w, h), 0, 0)

  // --- Pictures: an idle worker makes the next one. The first ones are made before the click ---
  const kAhead = 8 // pictures that stand ready, besides those being made
  const duration = x.duration(), from = Math.max(0, Math.min(parseFloat(q.get('from')) || 0, duration - 1))
  let ready, idle, spare, next, planned, lit, solved, unlit, playing, shown = 0, skipped = 0, first = 0, shownTime = -1
  const filmAt = () => !playing ? -1e9 : going ? x.at(now()) : stopped
  const give = () => {
    while (idle.length && !over && planned < duration && ready.length + count - idle.length < kAhead + count) {
      const [time, level, width, height] = next ??= [...new Float64Array(x.memory.buffer, x.plan(filmAt(), count), 4)]
      if (lit < count && x.lit(time)) {
        if (!unlit) return // not yet
      } else {
        const rgba = spare.pop()
        idle.pop().postMessage(['picture', { time, level, width, height }, rgba], rgba ? [rgba.buffer] : [])
      }
      planned = time, next = null
    }
  }
  // The light of the hall, which goes from worker to worker, so that it stands in memory once
  const light = hall => {
    const to = tracers[lit++] ?? solver
    to.postMessage(['light', hall], [hall.pages.buffer])
    if (lit == count) release('hall'), give()
  }
  const heard = (d, k) => {
    if (d.hall) return light(d.hall)
    if (d.still) return playing == null && paint(d.rgba)
    if (d.rgba) {
      x.spent(d.trace / 1e3, count)
      ready.push(d)
      ready.sort((a, b) => a.time - b.time)
    }
    idle.push(k), give()
  }
  const leaveOut = why => {
    unlit = `The light of the hall could not be solved (${why}): the scenes from 64 to 152 s are left out.`
    release('hall'), give()
  }
  // What they draw is as large as the screen, so that they are ready before the click; or as the page at the click,
  // which may have had another size, or none
  const prepare = () => {
    const [across, down] = (full ? [screen.width, screen.height] : [innerWidth || 1280, innerHeight || 720])
      .sort((a, b) => b - a)
    const wide = Math.max(16, Math.min(most, Math.round(across * dpr)))
    const high = Math.max(9, Math.round(wide * down / across))
    if (wide == w && high == h) return
    for (const k of tracers) k.terminate()
    solver?.terminate()
    canvas.width = w = wide, canvas.height = h = high
    ready = [], idle = [], spare = [], planned = from, next = unlit = null, lit = solved = 0
    x.begin(from, w, h)
    tracers = Array.from({ length: count }, () => start(heard, 'trace', module, w, h))
    tracers[0].postMessage(['picture', { time: 35, level: 1, width: 0, height: 0, still: 1 }])
    solver = start(d => {
      if (d.progress) solved = d.progress
      if (d.hall) solver.terminate(), light(d.hall)
    }, 'solve', module, w, h)
    solver.onerror = e => leaveOut(e.message)
  }

  // --- Music: scheduled ten seconds ahead, so that it goes on whatever else the machine does ---
  const kChunk = 100, kComposed = 10, kFirst = 2 // blocks at a time; seconds, and those before the click
  const seconds = kChunk * kBlock / kRate
  let audio, gain, zero, silent, asked = 0, scheduled = 0, settled = 0, waiting = [], clicked
  const composer = start(d => {
    if (d.left) waiting.push(d), schedule()
  }, 'compose', module, Math.round(from * kRate / kBlock))
  const compose = () => {
    const most = playing == null ? kFirst : kComposed + Math.max(0, filmAt() - from)
    for (; !silent && asked * seconds < most; ++asked) composer.postMessage(['sound', kChunk])
  }
  const schedule = () => {
    while (zero != null && waiting.length) {
      const s = audio.createBufferSource(), when = zero + scheduled++ * seconds
      const late = Math.max(0, audio.currentTime + 0.02 - when)
      const { left, right } = waiting.shift()
      s.buffer = audio.createBuffer(2, left.length, kRate)
      s.buffer.copyToChannel(left, 0), s.buffer.copyToChannel(right, 1)
      s.connect(gain)
      if (late < seconds) s.start(when + late, late)
    }
  }
  // The film's time that is heard now
  const heardAt = t => {
    const { contextTime, performanceTime } = audio.getOutputTimestamp?.() ?? {}
    return from - zero + (contextTime > 0 ? contextTime + (t - performanceTime) / 1e3
      : audio.currentTime - (audio.outputLatency || 0))
  }

  // --- The clock stands while something holds the film, or while its sound does ---
  const holds = new Set
  let stopped = from, going
  const check = () => {
    const t = now(), goes = playing && !holds.size && (silent || audio.state == 'running')
    if (!goes == !going) return
    if (!(going = goes)) return stopped = x.at(t)
    x.start(stopped - (silent ? 0 : 0.1), t)
    settled = t + 400
    say(unlit && x.lit(stopped) ? unlit : '')
  }
  const hold = why => {
    if (!holds.size) audio?.suspend()
    holds.add(why), check()
  }
  const release = why => {
    if (!holds.delete(why) || holds.size) return
    navigator.wakeLock?.request('screen').catch(() => {}) // phones would sleep
    if (!playing && !silent) zero = audio.currentTime + 0.1, schedule()
    playing = 1
    audio?.resume(), check()
  }

  // --- A refresh of the screen ---
  let lastSixtieth = -1, begun
  const step = (t = now()) => {
    if (over) return
    check()
    if (holds.has('start')) {
      const needs = x.lit(from) && lit < count && !unlit, share = Math.min(1, ready.length / 3)
      bar.style.width = 100 * (needs ? solved * 0.8 : (x.lit(from) ? 0.8 + share / 5 : share)) + '%'
      say(needs ? 'The light of the hall is being solved.' : '')
      const sounds = audio?.state == 'running'
      if (!sounds && t - clicked > 1500) silent = 1
      const heard = silent || sounds && waiting.length > 3
      if (heard && (ready.length >= 3 || unlit && x.lit(from))) bar.style.width = 0, begun = now(), release('start')
    } else if (going) {
      if (!silent && audio.currentTime > zero) t < settled ? x.start(heardAt(t), t) : x.correct(heardAt(t), t)
      const film = x.at(t)
      if (film >= duration) return end()
      if (x.lit(Math.max(film, from)) && lit < count) {
        if (!unlit) hold('hall')
        else say(unlit), draw.fillRect(0, 0, w, h)
      } else if (unlit && word.textContent) say('')
      let p
      while (ready[0]?.time <= film + 0.008) { // at the nearest refresh
        if (p) ++skipped, spare.push(p.rgba)
        p = ready.shift()
      }
      if (p && p.time > shownTime) {
        paint(p.rgba)
        spare.push(p.rgba)
        if (!shown++) first = now()
        const sixtieth = Math.floor((now() - begun) * 0.06)
        const missed = lastSixtieth < 0 ? 0 : Math.max(0, sixtieth - lastSixtieth - 1)
        x.shown(p.time, p.trace, now() - t, p.samples, p.width, missed)
        lastSixtieth = sixtieth
        shownTime = p.time
      }
    } else if (holds.has('hall')) {
      say('The light of the hall is being solved.')
      bar.style.width = 100 * solved + '%'
    }
    compose()
    give()
    requestAnimationFrame(step)
  }
  const statistics = () => {
    const b = new Uint8Array(x.memory.buffer, x.statistics((first - clicked) / 1e3), 4096)
    return new TextDecoder().decode(b.slice(0, b.indexOf(0)))
  }
  if (q.has('stats')) setInterval(() => { if (shown) printed.textContent = statistics() }, 1000)
  const end = () => {
    over = 1
    audio?.close()
    document.exitFullscreen?.().catch(() => {})
    if (q.has('stats')) printed.textContent = statistics()
    else location.reload()
  }

  // --- The viewer ---
  const fullScreen = () => full && document.documentElement.requestFullscreen?.()
    .then(() => screen.orientation.lock('landscape')).catch(() => {}) // phones turn it
  const play = () => {
    if (over) return
    if (playing != null) return audio?.resume()
    prepare()
    playing = 0, clicked = now()
    body.className = 'on'
    draw.fillRect(0, 0, w, h)
    fullScreen()
    try {
      audio = new AudioContext({ sampleRate: kRate })
      audio.resume()
      gain = audio.createGain()
      gain.connect(audio.destination)
    } catch { silent = 1 }
    holds.add('start')
    step()
  }
  onclick = play
  onkeydown = e => {
    const is = letter => [e.key.toUpperCase(), e.code.slice(3)].includes(letter) // on a key, or in its place
    if (e.key == 'Enter' || e.key == ' ') play()
    if (is('M') && gain) gain.gain.value = 1 - gain.gain.value
    if (is('F')) document.fullscreenElement ? document.exitFullscreen() : fullScreen()
    if (e.key == 'Escape' && playing != null) end()
  }
  document.onvisibilitychange = () => {
    if (playing != null && !over) document.hidden ? hold('hidden') : release('hidden')
  }
  prepare()
  compose()
  button.textContent = '\u25b6 play'
  // For tests
  const state = () => ({
    film: filmAt(), heard: zero != null && audio.state == 'running' ? heardAt(now()) : null, ready: ready.length,
    shown, skipped, shownTime, first: first - clicked, silent, holds: [...holds], unlit, hall: lit >= count, over,
  })
  self.film = { module, start, statistics, state }
}
