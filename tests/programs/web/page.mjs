// node page.mjs chromium|firefox|webkit PAGE OUT SECONDS...: opens and plays the page as a viewer does; prints each
// check. OUT gets the pictures of these seconds, 320x180 in quality `film`, the music's hash, and the file `plain` if
// the browser has no relaxed SIMD.
import { once } from 'node:events'
import { readFileSync, writeFileSync } from 'node:fs'
import { createServer } from 'node:http'
import { open, later } from './browser.mjs'

const [kind, page, out, ...seconds] = process.argv.slice(2)
let wrong = false
const check = (what, right, seen) => {
  console.log(`${right ? 'ok' : 'FAILED'}: ${kind}: ${what} (${JSON.stringify(seen)})`)
  wrong ||= !right
}
const until = async (b, what) => {
  for (const end = Date.now() + 1200e3; Date.now() < end; await later(100))
    if (await b.evaluate(what)) return true
  return false
}
// Waits until a condition is true, and checks that it came
const comes = async (b, what, condition, seen = 'film.state()') =>
  check(what, await until(b, condition), await b.evaluate(seen))

// --- A click while it is unpacked is remembered ---
const early = await open(kind, 'file://' + page + '?full=0')
const unpacks = await until(early, 'document.body && /unpacking .* \\d+ %/.test(document.body.innerText)')
await early.click()
const before = await early.evaluate('!self.film')
check('says that it is unpacked', unpacks && before, before)
await comes(early, '... and a click is remembered', 'self.film && film.state().shown > 0', 0)
await early.close()

const b = await open(kind, 'file://' + page + '?from=17')
try {
  const opens = await until(b, 'self.film && document.querySelector("button").textContent')
  check('opens', opens, await b.evaluate('document.title'))
  const reached = await b.evaluate('document.documentElement.lang + document.querySelector("button").tabIndex')
  check('has a language, and a button that Tab reaches', reached == 'en0', reached)

  const zero = [253, 12, ...Array(16).fill(0)], madd = [0, ...zero, ...zero, ...zero, 253, 133, 2, 26, 11]
  const type = [0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 3, 2, 1, 0]
  const module = [...type, 10, madd.length + 2, 1, madd.length, ...madd]
  if (!await b.evaluate(`WebAssembly.validate(Uint8Array.of(${module}))`)) writeFileSync(out + '/plain', '')

  // --- Pictures, which one worker with the hall's light draws ---
  await b.evaluate(`(async () => {
    const hall = await new Promise(done =>
      film.start(d => d.hall && done(d.hall), 'solve', film.module, 320, 180))
    let answered
    const tracer = film.start(d => answered(d), 'trace', film.module, 320, 180)
    const request = (...all) => new Promise(done => {
      answered = done
      if (all.length) tracer.postMessage(all)
    })
    await request()
    await request('light', hall)
    self.draw = async time => {
      const { rgba } = await request('picture', { time, level: 0, width: 0, height: 0 })
      return btoa(Array.from(rgba.filter((_, i) => i % 4 != 3), c => String.fromCharCode(c)).join(''))
    }
  })()`)
  for (const t of seconds) {
    const rgb = Buffer.from(await b.evaluate(`draw(${t})`), 'base64')
    writeFileSync(`${out}/${t}.ppm`, Buffer.concat([Buffer.from('P6\n320 180\n255\n'), rgb]))
  }

  // --- Music, written as by output/wav.cpp. One browser makes it; their pictures show that they round equally ---
  if (kind == 'chromium') writeFileSync(out + '/music.sha256', await b.evaluate(`new Promise(done => {
    const blocks = 164 * 200, size = blocks * 960, to = new DataView(new ArrayBuffer(44 + size))
    const text = 'RIFF    WAVEfmt                     data'
    const numbers = [[4, 36 + size], [16, 16], [20, 0x20001], [24, 48000], [28, 192000], [32, 0x100004], [40, size]]
    for (let i = 0; i < text.length; ++i) to.setUint8(i, text.charCodeAt(i))
    for (const [at, v] of numbers) to.setUint32(at, v, true)
    let n = 0
    const random = x => {
      const s = Math.imul(x, 747796405) + 2891336453 >>> 0
      const w = Math.imul((s >>> (s >>> 28) + 4 ^ s) >>> 0, 277803737) >>> 0
      return (w >>> 22 ^ w) >>> 0
    }
    const even = x => { const r = Math.round(x); return r - x == 0.5 && r % 2 ? r - 1 : r }
    const k = film.start(async ({ left, right }) => {
      for (let i = 0; i < left.length; ++i) for (const side of [left, right]) {
        const r = random(n), dither = ((r & 0xffff) - (r >>> 16)) / 65536
        to.setInt16(44 + 2 * n++, even(Math.fround(side[i] * 32767 + dither)), true)
      }
      if (n < blocks * 480) return k.postMessage(['sound', 200])
      k.terminate()
      const hash = new Uint8Array(await crypto.subtle.digest('SHA-256', to))
      done(Array.from(hash, v => v.toString(16).padStart(2, 0)).join(''))
    }, 'compose', film.module, 0)
    k.postMessage(['sound', 200])
  })`) + '  -\n')

  // --- Playing ---
  const script = text => b.evaluate(`document.body.append(Object.assign(document.createElement('script'),
    { text: ${JSON.stringify(text)} }))`)
  await b.screenshot(`${out}/poster.png`)
  // A script of the page, since Firefox's tests have arrays of their own, which its sound does not fill
  const measureSound = () => {
    const make = AudioContext.prototype.createGain
    AudioContext.prototype.createGain = function() {
      const g = self.gain = make.call(this), level = this.createAnalyser(), samples = new Float32Array(2048)
      g.connect(level)
      self.loud = () => { level.getFloatTimeDomainData(samples); return Math.max(...samples) }
      return g
    }
  }
  await script(`(${measureSound})()`)
  await b.click()
  await comes(b, 'plays from 17 s', 'film.state().shown > 0 && film.state().film > 16.5')
  await comes(b, 'fills the screen', 'document.fullscreenElement', '[innerWidth, innerHeight]')
  await comes(b, 'goes on', 'film.state().film > 18.5')
  if (kind != 'firefox') { // has no sound here
    await comes(b, 'is heard', 'loud() > 0.001', 'loud()')
    const together = '(s => s.heard && Math.abs(s.heard - s.film) < 0.02)(film.state())'
    await comes(b, '... together with the pictures', together)
    await b.key('m')
    await comes(b, 'is muted by M', 'gain.gain.value == 0 && loud() == 0', 'loud()')
    await b.key('m')
    await comes(b, '... and heard again', 'loud() > 0.001', 'loud()')
  }
  await b.key('f')
  await comes(b, 'leaves the full screen by F', '!document.fullscreenElement')
  await b.screenshot(`${out}/playing.png`)
  const stopped = await b.evaluate(`(async () => {
    const hide = yes => {
      Object.defineProperty(document, 'hidden', { value: yes, configurable: true })
      document.dispatchEvent(new Event('visibilitychange'))
    }
    hide(true)
    const before = film.state().film
    await new Promise(r => setTimeout(r, 500))
    const after = film.state().film
    hide(false)
    return after - before
  })()`)
  check('pauses while its tab is hidden', stopped == 0, stopped)
  await comes(b, '... and goes on', `film.state().shown > ${await b.evaluate('film.state().shown') + 5}`)
  const at = () => b.evaluate('film.state().film')
  await b.click()
  const paused = await at()
  await later(500)
  check('pauses by a click', await at() == paused && paused > 0, paused)
  await b.key(' ')
  await comes(b, '... and goes on by space', `film.state().film > ${paused}`)
  await b.key('ArrowRight')
  await comes(b, 'seeks by an arrow, and plays on', `film.state().film > ${paused + 5.2}`)
  const press = 'const press = (key, more) => document.body.dispatchEvent(new KeyboardEvent("keydown", { key, ' +
    'bubbles: true, ...more }))\n'
  const moved = await b.evaluate(`new Promise(done => {
    ${press}
    const before = film.state().film
    for (const more of [{ ctrlKey: true }, { altKey: true }, { metaKey: true }, { repeat: true }])
      for (const name of ['ArrowLeft', ' ', 'Escape']) press(name, more)
    setTimeout(() => done(film.state().film - before), 500)
  })`)
  check('ignores keys with Ctrl, Alt and Meta, and repeats', moved > 0, moved)
  const left = await b.evaluate(`new Promise(done => {
    ${press}
    film.kept = true, press('Escape')
    done(!film.state().playing && !document.body.className)
  })`)
  check('shows the poster after ESC', left, left)
  await b.click()
  await comes(b, '... and plays again without unpacking',
    'film.kept && film.state().shown > 0 && film.state().film > 16.5')
  await b.resize(700, 600)
  await comes(b, 'is as large as its window', 'document.querySelector("canvas").clientWidth == innerWidth')
  check('prints its statistics', /table +\d+/.test(await b.evaluate('film.statistics()')), 'table')
  check('has printed no error', !b.errors.length, b.errors)
  const foreign = `Promise.reject(Error('of another script'))
    document.body.dispatchEvent(new Event('keydown', { bubbles: true }))
    throw Error('of another script')`
  await script(foreign)
  await comes(b, "goes on after another script's errors", `film.state().film > ${await at() + 0.2}`)
  await b.evaluate('film.start(() => {}, "trace", film.module, 16, 9).dispatchEvent(new Event("error")), 0')
  const why = await b.evaluate('document.querySelector("p").textContent')
  check('says why it stops', why == 'The film has stopped: the browser could not run a worker', why)
} catch (e) {
  check('the browser answers', false, String(e.stack))
}
await b.close()

// --- From a server, as on web sites: with another charset, a policy, a frame that is hidden while it loads ---
const frame = '<iframe id=f src="/?full=0" style="display:none;position:fixed;left:0;top:0;width:1000px;height:500px">'
const policies = { '/policy': "default-src 'self' 'unsafe-inline'", '/wasm': "default-src 'self' 'unsafe-inline' blob:",
  '/sandbox': 'sandbox allow-scripts' }
const charset = kind == 'chromium' ? 'windows-1251' : 'utf-8'
const server = createServer(({ url }, answer) => {
  const policy = policies[url.split('?')[0]]
  answer.setHeader('Content-Type', 'text/html' + (policy ? '' : '; charset=' + charset))
  if (policy) answer.setHeader('Content-Security-Policy', policy)
  answer.end(url == '/frame' ? frame : readFileSync(page))
}).listen(0, '127.0.0.1')
await once(server, 'listening')
const site = `http://127.0.0.1:${server.address().port}`
// Each takes seconds, so two browsers share the policies, and two the frame
const shared = { chromium: ['/policy', '/sandbox'], firefox: ['/wasm', '/sandbox'], webkit: ['/wasm'] }
for (const path of shared[kind]) {
  const s = await open(kind, `${site}${path}?full=0`), play = 'self.film && film.state().shown > 0'
  await until(s, 'self.film?.state().ready > 2 || /cannot play/.test(document.body?.innerText)')
  const says = await s.evaluate('self.film ? "" : document.body.innerText')
  if (!says) await s.click()
  const right = says ? /cannot play the film\.$/.test(says) : await until(s, play)
  check(path + ' plays, or says why it cannot', right, says)
  await s.close()
}
if (kind != 'firefox') {
  const hidden = await open(kind, site + '/frame')
  await comes(hidden, 'loads hidden', 'self.f?.contentWindow.film?.state().ready > 2', 0)
  await hidden.evaluate('f.style.display = "block"')
  await hidden.click()
  await comes(hidden, '... and plays', 'f.contentWindow.film.state().shown > 0', 0)
  const wide = await hidden.evaluate('f.contentDocument.querySelector("canvas").width')
  check('... in the size of its frame', wide == 1000, wide)
  await hidden.close()
}
server.close()

process.exit(wrong ? 1 : 0)
